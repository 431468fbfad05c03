def log = new File(basedir, "build.log").text
assert log.contains("PASSED: 2 of 2 scenarios passed")
assert log.contains("FAILED: 1 of 2 scenarios passed")
def target = new File(basedir, "target/eventchain")
def left = (target.list() as List).findAll { it.endsWith(".sarif") || it.endsWith(".xml") }.sort()
assert left == ["TEST-simulate.xml", "simulate.sarif"]
assert new File(target, "TEST-simulate.xml").text.contains("<failure")
assert new File(basedir, "target/results/verdict.json").text.contains("\"passed\" : false")
assert !new File(basedir, "target/results/report.html").exists()
