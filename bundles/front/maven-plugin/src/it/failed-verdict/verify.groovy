def log = new File(basedir, "build.log").text
def failure = log.readLines().find { it.contains("Failed to execute goal") }
assert failure.contains(":report (default)")
assert failure.contains("[simulation.criterion.failed")
assert log.contains("FAILED: 1 of 2 scenarios passed")
assert new File(basedir, "target/eventchain/TEST-report.xml").text.contains("<failure")
assert new File(basedir, "target/eventchain/failed-verdict/report.html").length() > 0
