package dev.eventchain.check;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.project.ProjectFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * An example of the project, or a copy of it that a test may change.
 *
 * @param path its folder
 */
record ProjectCopy(Path path) {

  /** Project with an edited chain model, its own messages and no design rules. */
  static final Path RADAR = Path.of("../../../examples/radar-aeb").toAbsolutePath().normalize();

  /** Copies the example into a folder. */
  static ProjectCopy in(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(RADAR)) {
      for (Path file : files.filter(each -> !each.startsWith(RADAR.resolve("out"))).toList()) {
        Path copy = folder.resolve(RADAR.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(copy);
        } else {
          Files.copy(file, copy);
        }
      }
    }
    return new ProjectCopy(folder);
  }

  Path file(String name) {
    return path.resolve(name);
  }

  ProjectFolder opened() {
    return new ProjectFolder(path);
  }

  Path output() {
    return opened().defaultOutput();
  }

  /** Replaces a text that occurs once in a file. */
  void replace(String name, String text, String by) throws IOException {
    String content = Files.readString(file(name));
    assertEquals(2, content.split(Pattern.quote(text), -1).length, text);
    Files.writeString(file(name), content.replace(text, by));
  }

  /** Writes a file. */
  void write(String name, String text) throws IOException {
    Files.createDirectories(file(name).getParent());
    Files.writeString(file(name), text);
  }
}
