def log = new File(basedir, "build.log").text
assert log.contains("[ERROR] pom.xml:20:") && log.contains("The plugin has no parameter <constraint>. [maven.parameter]")
