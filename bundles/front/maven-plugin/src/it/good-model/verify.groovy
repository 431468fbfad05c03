def log = new File(basedir, "build.log").text
assert log.contains("0 errors, 0 warnings in 3 files: 3 elements, 1 constraint evaluated 2 times")
assert new File(basedir, "target/eventchain/validate.sarif").text.contains('"results" : [ ]')
assert new File(basedir, "target/eventchain/TEST-validate.xml").text.contains('Book::HasPages')
