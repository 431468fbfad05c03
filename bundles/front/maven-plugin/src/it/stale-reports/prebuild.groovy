import java.nio.file.Files

// The example twice, once with a criterion that its vehicle cannot meet.
def example = new File(basedir, "../../../../../../examples/radar-aeb").canonicalFile.toPath()
for (copied in ["sound", "broken"]) {
  for (name in ["eventchain.yaml", "bench.yaml", "requirements.md", "model", "software-base", "scenarios"]) {
    Files.walk(example.resolve(name)).filter { Files.isRegularFile(it) }.forEach {
      def copy = basedir.toPath().resolve(copied).resolve(example.relativize(it))
      Files.createDirectories(copy.parent)
      Files.copy(it, copy)
    }
  }
}
// Its reports are the same without the strength of requirements.
def settings = new File(basedir, "sound/eventchain.yaml")
settings.text = settings.text.replaceAll("(?m)^strength:\n(?: .*\n)*", "strength: off\n")
def scenario = new File(basedir, "broken/scenarios/short-sight.yaml")
assert scenario.text.contains("ego.speed <= 12 km/h")
scenario.text = scenario.text.replace("ego.speed <= 12 km/h", "ego.speed >= 200 km/h")
return true
