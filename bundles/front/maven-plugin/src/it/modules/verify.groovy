def log = new File(basedir, "build.log").text
assert log.contains("MultiThreadedBuilder")
assert !log.contains("not marked @threadSafe") && !log.contains("not marked as thread-safe")
def outcome = { module -> log.readLines().find { it ==~ /\[INFO\] $module \.+ [A-Z]+ .*/ } }
def failure = { module -> log.readLines().find { it.contains("Failed to execute goal") && it.contains("on project $module:") } }
def report = { module, name -> new File(basedir, "$module/target/eventchain/$name").text }

// By its mapping.
assert outcome("checked").contains("SUCCESS")
assert report("checked", "TEST-validate.xml").contains('Book::HasPages')

// For a warning.
assert outcome("warned").contains("FAILURE")
assert report("warned", "validate.sarif").contains('"level" : "warning"')
assert log.contains("warned/models/town.xmi:4:3: ")

// Without models, and it may.
assert outcome("empty").contains("SUCCESS")
assert log.contains("[WARNING] empty: There is no model") || log.contains("maven.nothing-to-check")

assert outcome("good-model").contains("SUCCESS")
assert log.count("0 errors, 0 warnings in 3 files: 3 elements, 1 constraint evaluated 2 times") == 2 : "checked, too"
assert report("good-model", "validate.sarif").contains('"results" : [ ]')
assert report("good-model", "TEST-validate.xml").contains('Book::HasPages')

def finding = "bad-model/src/main/models/town.library:4:3: "
assert outcome("bad-model").contains("FAILURE")
assert log.readLines().any { it.startsWith("[ERROR] " + finding) && it.contains("[ocl.violated Book::HasPages]") }
assert failure("bad-model").contains(":validate (default)")
assert failure("bad-model").contains(finding)
assert failure("bad-model").contains("[ocl.violated Book::HasPages]; 1 error, 0 warnings in 3 files")
assert failure("bad-model").contains("MojoFailureException") || log.contains("MojoFailureException")
assert report("bad-model", "validate.sarif").contains("src/main/models/town.library")
assert report("bad-model", "TEST-validate.xml").contains("<failure")

assert outcome("misspelt").contains("FAILURE")
assert log.contains("[ERROR] misspelt/pom.xml:19:") && log.contains("The plugin has no parameter <constraint>. [maven.parameter]")
assert log.contains("Did you mean `constraints`?")
assert log.contains("The element <mappings> has no value. [maven.parameter]")
assert log.count("[maven.parameter]") == 3 : "two findings, and the first of them as the failure"

// Without models, and it must not.
assert outcome("nothing-to-check").contains("FAILURE")
assert log.contains("[ERROR] nothing-to-check: There is no model and no event chain to check. [maven.nothing-to-check]")
assert report("nothing-to-check", "TEST-validate.xml").contains("maven.nothing-to-check")

// One folder is formatted, and the whole module is checked, without being changed.
assert outcome("unformatted").contains("FAILURE")
assert log.contains("[INFO] Formatted unformatted/written/rules.ocl")
def rules = { folder -> new File(basedir, "unformatted/$folder/rules.ocl").text }
assert rules("written") == "context Book\n    inv A: self.name <> ''\n"
assert rules("checked") == "context Book\ninv A:self.name<>''\n"
assert failure("unformatted").contains(":format (checked)")
assert failure("unformatted").contains("unformatted/checked/rules.ocl:2:1: ")
assert report("unformatted", "TEST-format-written.xml").contains('failures="0"')
assert report("unformatted", "format-checked.sarif").contains("format.differs")
