"""Doxygen's filter of headers: prints the header in argument 1, line by line.

It leaves out members that are deleted, comparisons and moves that do what every reader expects, and
forward declarations; and it repeats the comment behind a declaration of several variables for each
of them, as Doxygen gives it to one alone.
"""

import re
import sys

DELETED = re.compile(r"^.*= delete;$")
EXPECTED = re.compile(r"^ *(friend )?bool operator==\(.*\).*;$|^ *\w+(& operator=)?\(\w+&&( \w+)?\) noexcept;$")
SEVERAL = re.compile(r"^(?P<indent> +)(?P<type>[\w:<>]+) (?P<names>\w+( = [^,;()]+)?(, \w+( = [^,;()]+)?)+);"
                     r" +///< (?P<comment>.*)$")


def filtered(line):
    if DELETED.match(line) or EXPECTED.match(line):
        return ""
    several = SEVERAL.match(line)
    if not several:
        return line
    return several["indent"] + " ".join(f"{several['type']} {name}; /**< {several['comment']} */"
                                        for name in several["names"].split(", "))


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as header:
        for text in header.read().splitlines():
            print(filtered(text))
