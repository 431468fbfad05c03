# Stands in for the command line: says what it was called with, and writes the report that is asked for.
report=
called=
for word in "$@"; do
  case $word in
    --report=json=*) report=${word#--report=json=} ;;
    *) called="$called $word" ;;
  esac
done
called=${called# }
case $1 in
  run)
    printf '\r\033[K  Simulate  one' >&2
    printf '\r\033[K  Simulate  two' >&2
    printf '\r\033[Kdone\n' >&2
    ;;
  mutate)
    trap 'kill $!; exit 143' TERM
    sleep 600 &
    echo $! >sleeper
    wait
    ;;
  simulate) exit 0 ;;
  measure)
    case $called in
      *drive*)
        mkdir -p p/out/traced
        printf -- '--- a/requirements.md\n+++ b/requirements.md\n@@ -1,1 +1,1 @@\n-# One\n+# Longer\n' \
          >p/out/traced/measured-times.diff
        ;;
    esac
    ;;
esac
case $1 in
  generate) echo '{"findings": [{"file": "/etc/passwd", "message": "root:x:0:0"}]}' >"$report" ;;
  campaign)
    {
      printf '{"findings": [{}'
      i=1
      while [ $i -lt 250 ]; do
        printf ', {}'
        i=$((i + 1))
      done
      printf ']}'
    } >"$report"
    ;;
  bench | init | explain) echo "$called" ; exit 0 ;;
  *) [ -z "$report" ] || echo '{"exitCode": 0, "files": ["p/requirements.md"], "findings": []}' >"$report" ;;
esac
echo done >&2
echo "PASSED: $called"
case $called in
  *failing*) exit 1 ;;
  *unreadable*) exit 2 ;;
esac
