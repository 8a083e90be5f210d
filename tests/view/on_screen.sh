# on_screen.sh COMMAND...: runs it on a screen of its own that has no monitor.
rm -f display.txt
Xvfb -displayfd 3 -screen 0 800x600x24 3> display.txt 2> screen.txt &
screen=$!
tries=0
# The number of the display is there when its line has ended.
until [ "$(cat display.txt 2> /dev/null | wc -l)" -ge 1 ] || [ $tries -ge 300 ]; do
  sleep 0.1
  tries=$((tries + 1))
done
DISPLAY=:$(cat display.txt) "$@"
code=$?
kill $screen
wait $screen
exit $code
