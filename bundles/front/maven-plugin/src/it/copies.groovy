import java.nio.file.Files
import java.nio.file.Path

// A closure that copies the example with a radar into a folder, without results.
def example = new File(basedir, "../../../../../../examples/radar-aeb").canonicalFile.toPath()
return { Path folder ->
  for (name in ["eventchain.yaml", "bench.yaml", "requirements.md", "model", "software-base", "scenarios"]) {
    Files.walk(example.resolve(name)).filter { Files.isRegularFile(it) }.forEach {
      def copy = folder.resolve(example.relativize(it))
      Files.createDirectories(copy.parent)
      Files.copy(it, copy)
    }
  }
  // The goals are the same without the strength of requirements, which takes longer than the rest.
  def settings = folder.resolve("eventchain.yaml").toFile()
  settings.text = settings.text.replaceAll("(?m)^strength:\n(?: .*\n)*", "") + "\nstrength: off\n"
}
