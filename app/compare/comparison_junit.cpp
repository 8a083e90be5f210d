#include <fmt/format.h>

#include "app/base/quoting.h"
#include "app/compare/comparison_report.h"

namespace app {
namespace {

struct JunitCases {
  std::string text;
  int count = 0;
  int failures = 0;

  void add(const std::string& subject, const std::string& name, const std::string& failure) {
    ++count;
    failures += !failure.empty();
    const std::string head =
        fmt::format("  <testcase classname=\"{}\" name=\"{}\"", xml_text(subject), xml_text(name));
    text += failure.empty() ? head + "/>\n"
                            : fmt::format("{}>\n    <failure message=\"{}\"/>\n  </testcase>\n",
                                          head, xml_text(failure));
  }
};

std::string failure_of(const Difference& d) {
  if (d.within()) return "";
  return fmt::format("differs by up to {:g} {} at {:g} s, tolerance {}, {}; rms {:g}", d.largest,
                     d.unit, d.when_largest, limits_text(d), verdict(d), d.rms);
}

/// Adds the cases of a body or of a name of a table. @param times   The case of its rows.
void add_cases(const BodyComparison& body, const std::string& times, const ComparedFiles& files,
               JunitCases& cases) {
  if (!body.judged) return;
  const std::string note = coverage(body, files);
  cases.add(body.name, times, note);
  for (const Difference& d : body.differences)
    if (d.judged()) cases.add(body.name, d.quantity, failure_of(d));
}

std::string suite_of(const JunitCases& cases, const ComparedFiles& files) {
  return fmt::format(
      "<testsuite name=\"{0} and {1}\" tests=\"{2}\" failures=\"{3}\">\n"
      "  <properties>\n    <property name=\"A\" value=\"{0}\"/>\n"
      "    <property name=\"B\" value=\"{1}\"/>\n  </properties>\n{4}</testsuite>\n",
      xml_text(files.a), xml_text(files.b), cases.count, cases.failures, cases.text);
}

}  // namespace

std::string junit_suite_of(const Comparison& comparison, const ComparedFiles& files) {
  JunitCases cases;
  for (const BodyComparison& body : comparison.bodies) add_cases(body, "times", files, cases);
  for (const TableComparison& table : comparison.tables) {
    if (table.in != In::both && table.judged)
      cases.add(table.name, "table", only_in(table.in, files));
    for (const BodyComparison& name : table.names)
      add_cases(name, table.name + ".times", files, cases);
  }
  return suite_of(cases, files);
}

std::string junit_suite_of_fault(const std::string& run, const std::string& fault,
                                 const ComparedFiles& files) {
  JunitCases cases;
  cases.add(run, "run", fault);
  return suite_of(cases, files);
}

std::string junit_file_of(const std::vector<std::string>& suites) {
  const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  if (suites.size() == 1) return head + suites.front();
  return fmt::format("{}<testsuites>\n{}</testsuites>\n", head, fmt::join(suites, ""));
}

}  // namespace app
