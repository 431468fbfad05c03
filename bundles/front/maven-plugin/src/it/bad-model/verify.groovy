def log = new File(basedir, "build.log").text
def finding = "src/main/models/town.library:4:3: "
assert log.readLines().any { it.startsWith("[ERROR] " + finding) && it.contains("[ocl.violated Book::HasPages]") }
def failure = log.readLines().find { it.contains("Failed to execute goal") }
assert failure.contains(":validate (default)")
assert failure.contains(finding)
assert failure.contains("[ocl.violated Book::HasPages]; 1 error, 0 warnings in 3 files")
assert failure.contains("MojoFailureException") || log.contains("MojoFailureException")
assert new File(basedir, "target/eventchain/validate.sarif").text.contains("src/main/models/town.library")
assert new File(basedir, "target/eventchain/TEST-validate.xml").text.contains("<failure")
