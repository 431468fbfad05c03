def log = new File(basedir, "build.log").text
assert log.contains("[ERROR] pom.xml:19:") && log.contains("The plugin has no parameter <constraint>. [maven.parameter]")
assert log.contains("Did you mean `constraints`?")
assert log.contains("The element <mappings> has no value. [maven.parameter]")
assert log.count("[maven.parameter]") == 3 : "two findings, and the first of them as the failure"
