def log = new File(basedir, "build.log").text
assert log.contains("PASSED: 2 of 2 scenarios passed")
def target = new File(basedir, "target/eventchain")
assert new File(target, "radar-aeb/verdict.json").text.contains("\"passed\" : true")
assert new File(target, "radar-aeb/report.html").text.contains("short-sight")
// What was simulated is not simulated again for the page.
assert log =~ /Simulate +done/
assert log =~ /Simulate +unchanged/
for (name in ["simulate.sarif", "TEST-simulate.xml", "report.sarif", "TEST-report.xml"]) {
  assert new File(target, name).length() > 0
}
