def log = new File(basedir, "build.log").text
assert log.contains("MultiThreadedBuilder")
assert !log.contains("not marked @threadSafe") && !log.contains("not marked as thread-safe")
def outcome = { module -> log.readLines().find { it ==~ /\[INFO\] $module \.+ [A-Z]+ .*/ } }
assert outcome("checked").contains("SUCCESS")
assert outcome("warned").contains("FAILURE")
assert outcome("empty").contains("SUCCESS")
assert new File(basedir, "checked/target/eventchain/TEST-validate.xml").text.contains('Book::HasPages')
assert new File(basedir, "warned/target/eventchain/validate.sarif").text.contains('"level" : "warning"')
assert log.contains("warned/models/town.xmi:4:3: ")
assert log.contains("[WARNING] empty: There is no model") || log.contains("maven.nothing-to-check")
