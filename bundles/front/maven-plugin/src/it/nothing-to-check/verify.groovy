def log = new File(basedir, "build.log").text
assert log.contains("[ERROR] .: There is no model and no event chain to check. [maven.nothing-to-check]")
assert new File(basedir, "target/eventchain/TEST-validate.xml").text.contains("maven.nothing-to-check")
