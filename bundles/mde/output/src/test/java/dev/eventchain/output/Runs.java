package dev.eventchain.output;

import static java.nio.charset.StandardCharsets.UTF_8;

import dev.eventchain.output.OutputFolder.Outcome;
import java.nio.file.Path;

/** Runs that write one file each. */
final class Runs {

  private Runs() {}

  static byte[] bytes(String text) {
    return text.getBytes(UTF_8);
  }

  static Outcome write(Path base, String name, String content) {
    try (OutputFolder folder = OutputFolder.open(base)) {
      return folder.write(name, bytes(content)).outcome();
    }
  }
}
