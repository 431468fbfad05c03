package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * A project whose run has ended and passed: two scenarios of the AEB example, for a test to change.
 * The run happens once for all classes.
 *
 * @param path the project's folder
 */
record FinishedRun(Path path) {

  private static Path finished;

  /** Copies the project with its output into a new folder {@code aeb} of a folder. */
  static FinishedRun in(Path folder) throws IOException {
    Path copy = folder.resolve("aeb");
    copy(finished(), copy);
    FinishedRun run = new FinishedRun(copy);
    assertTrue(run.verdict().contains("\"passed\" : true,"));
    return run;
  }

  private static synchronized Path finished() throws IOException {
    if (finished == null) {
      Path folder = Program.ROOT.resolve("tests/end-to-end/target/finished-run");
      delete(folder);
      Path project = Program.exampleIn(folder);
      new Program().run("run", project).expect(0);
      finished = project;
    }
    return finished;
  }

  /** Copies a folder with the times of its files. */
  static void copy(Path from, Path to) throws IOException {
    Files.createDirectories(to.getParent());
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.toList()) {
        Path target = to.resolve(from.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(target);
        } else {
          Files.copy(file, target, StandardCopyOption.COPY_ATTRIBUTES);
        }
      }
    }
  }

  /** Deletes a file or a folder, if it is there. */
  static void delete(Path path) throws IOException {
    if (!Files.exists(path)) {
      return;
    }
    try (Stream<Path> all = Files.walk(path)) {
      all.sorted(Comparator.reverseOrder())
          .forEach(
              each -> {
                try {
                  Files.delete(each);
                } catch (IOException e) {
                  throw new UncheckedIOException(e);
                }
              });
    }
  }

  /** Runs a command, with the project as its first argument. */
  Program.Ended run(String command) {
    Path handoff = path.resolveSibling("handoff");
    List<Object> words =
        new ArrayList<>(List.of(command.replace("HERE", handoff.toString()).split(" ", -1)));
    words.add(1, path);
    return new Program().run(words.toArray());
  }

  String verdict() throws IOException {
    return Files.readString(out("verdict.json"));
  }

  /** Returns the path of an output. */
  Path out(String name) {
    return path.resolve("out").resolve(name);
  }

  /** Appends a line to a file of the project; DELETE deletes the file. */
  void append(String file, String text) throws IOException {
    if (text.equals("DELETE")) {
      Files.delete(path.resolve(file));
      return;
    }
    Files.writeString(
        path.resolve(file), text + "\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
  }

  /** Fails if a verdict, a measurement or a report says that the project passes. */
  void assertNothingPasses() throws IOException {
    assertTrue(verdict().contains("\"passed\" : false,"), verdict());
    assertFalse(verdict().contains("true"), verdict());
    for (String name : List.of("measurements.json", "measurements.csv", "chain.measured.xmi")) {
      assertFalse(Files.exists(out(name)), name);
    }
    if (Files.exists(out("report.html"))) {
      assertFalse(Files.readString(out("report.html")).contains("\"verdict\":\"passed\""));
    }
  }
}
