import java.nio.file.Files

// The example, with a criterion that its vehicle cannot meet.
def example = new File(basedir, "../../../../../../examples/radar-aeb").canonicalFile.toPath()
for (name in ["eventchain.yaml", "bench.yaml", "requirements.md", "model", "software-base", "scenarios"]) {
  Files.walk(example.resolve(name)).filter { Files.isRegularFile(it) }.forEach {
    def copy = basedir.toPath().resolve(example.relativize(it))
    Files.createDirectories(copy.parent)
    Files.copy(it, copy)
  }
}
def scenario = new File(basedir, "scenarios/short-sight.yaml")
def text = scenario.text
assert text.contains("ego.speed <= 12 km/h")
scenario.text = text.replace("ego.speed <= 12 km/h", "ego.speed >= 200 km/h")
return true
