def folder = new File(basedir, "target/generated-sources/eventchain/samples")
assert folder.list() as List == ["Titles.java"]
def written = new File(folder, "Titles.java")
assert written.text.contains("/** What the library has. */")
assert written.text.contains("public static final int MODELS = 200;")
def log = new File(basedir, "build.log").text
assert log.count("1 file in target/generated-sources/eventchain: 1 written") == 3
assert log.count("1 file in target/generated-sources/eventchain: 1 unchanged") == 1
