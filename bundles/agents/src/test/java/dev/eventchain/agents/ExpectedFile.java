package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.stream.Stream;

/** Inputs that lie beside the result that is expected of them. */
final class ExpectedFile {
  private ExpectedFile() {}

  /** The files of a folder with a suffix, by name. */
  static List<Path> inputs(String folder, String suffix) throws IOException {
    try (Stream<Path> files = Files.list(Path.of("src/test/resources").resolve(folder))) {
      return files.filter(file -> file.toString().endsWith(suffix)).sorted().toList();
    }
  }

  /** Compares with {@code NAME.expected}; a missing one is written, to be looked at. */
  static void check(Path input, String actual) throws IOException {
    String name = input.getFileName().toString();
    Path expected = input.resolveSibling(name.substring(0, name.lastIndexOf('.')) + ".expected");
    if (!Files.exists(expected)) {
      Files.writeString(expected, actual);
      throw new AssertionError("wrote " + expected + ": look at it and run again");
    }
    assertEquals(Files.readString(expected), actual);
  }

  /**
   * Findings in a form that is easy to read beside the input; messages of other bundles are their
   * own matter.
   */
  static String lines(Collection<Diagnostic> diagnostics) {
    StringBuilder out = new StringBuilder();
    for (Diagnostic diagnostic : diagnostics) {
      out.append(diagnostic.severity()).append(' ');
      out.append(diagnostic.location().line()).append(':').append(diagnostic.location().column());
      out.append(' ').append(diagnostic.location().element()).append(' ').append(diagnostic.id());
      if (diagnostic.id().startsWith("agents.")) {
        out.append(": ").append(diagnostic.message());
      }
      out.append('\n');
    }
    return out.toString();
  }
}
