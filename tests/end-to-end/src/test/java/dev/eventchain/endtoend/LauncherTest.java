package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the launcher with a copy of the build's output, as on a user's machine. */
class LauncherTest {

  /** Script that pretends to create archives. */
  static final String FORGER =
      """
      case "$*" in
        *dev.eventchain.cli.Rehearsal*) echo rehearsal >>calls
          for word; do case $word in -XX:ArchiveClassesAtExit=*)
            echo "no archive" >"${word#*=}" ;; esac; done; exit 0 ;;
      esac
      """;

  @TempDir Path folder;
  private Path home;
  private Path application;

  @BeforeEach
  void install() throws IOException {
    home = folder.resolve("home");
    for (String part :
        List.of(
            "eventchain",
            "bundles/front/cli/src/main/shell",
            "bundles/front/cli/target/eventchain/lib",
            "examples/aeb",
            "metamodel",
            "templates")) {
      copy(Program.ROOT.resolve(part), home.resolve(part));
    }
    application = home.resolve("bundles/front/cli/target/eventchain");
    Files.writeString(application.resolve("built"), "now\n");
  }

  @InTurn
  @Test
  void theFirstCommandMakesAnArchiveThatLaterOnesUse() throws IOException {
    assertVersionAlone(version());
    Path archive = archive();
    FileTime made = Files.getLastModifiedTime(archive);
    assertVersionAlone(version());
    assertEquals(made, Files.getLastModifiedTime(archive()));
    assertTrue(loadedFrom(archive).contains("dev.eventchain.cli.Main source: shared objects file"));
    assertTrue(loadedFrom(archive).contains("pipeline.run.Stage source: shared objects file"));
    assertEquals(List.of(), leftOvers());
  }

  @InTurn
  @Test
  void twoFirstCommandsAtOnceDoNotMix() throws Exception {
    Process one = start(System.getProperty("java.home"), "one");
    Process two = start(System.getProperty("java.home"), "two");
    assertEquals(0, one.waitFor());
    assertEquals(0, two.waitFor());
    assertVersionAlone(ended("one", one));
    assertVersionAlone(ended("two", two));
    assertTrue(loadedFrom(archive()).contains("dev.eventchain.cli.Main source: shared objects"));
    assertEquals(List.of(), leftOvers());
  }

  @Test
  void aNewBuildAndAnotherPlaceHaveArchivesOfTheirOwn() throws IOException {
    String java = fakeJava("one", FORGER);
    assertVersionAlone(version(java));
    assertVersionAlone(version(java));
    assertEquals(1, rehearsals());
    Instant later = Files.getLastModifiedTime(archive()).toInstant().plusMillis(5);
    Files.setLastModifiedTime(application.resolve("built"), FileTime.from(later));
    assertVersionAlone(version(java));
    assertEquals(2, rehearsals());
    Path moved = Files.move(home, folder.resolve("another home"));
    home = moved;
    application = home.resolve("bundles/front/cli/target/eventchain");
    assertVersionAlone(version(java));
    assertEquals(3, rehearsals());
  }

  @Test
  void eachJavaHasItsOwnAndADamagedOneIsIgnoredWithoutAWord() throws IOException {
    assertVersionAlone(version(fakeJava("one", FORGER)));
    assertVersionAlone(version(fakeJava("two", FORGER)));
    assertVersionAlone(version(fakeJava("one", FORGER)));
    assertEquals(2, rehearsals());
    try (Stream<Path> files = Files.list(application)) {
      assertEquals(2, files.filter(f -> f.toString().endsWith(".jsa")).count());
    }
  }

  @Test
  void anArchiveThatCannotBeMadeIsNotMissedAndNotTriedAgain() throws IOException {
    String java = fakeJava("other", FORGER.replace("exit 0", "exit 1"));
    assertVersionAlone(version(java));
    assertVersionAlone(version(java));
    assertEquals(1, rehearsals());
    assertEquals(0, Files.size(archive()));
    assertEquals(List.of(), leftOvers());
  }

  @Test
  void aJavaThatDoesNotSayWhichItIsHasNoArchive() throws IOException {
    String java = fakeJava("x", FORGER);
    Files.delete(folder.resolve("jdk-x/release"));
    assertVersionAlone(version(java));
    try (Stream<Path> files = Files.list(application)) {
      assertTrue(files.noneMatch(f -> f.toString().contains("classes")));
    }
  }

  @Test
  void anInstallationThatCannotBeWrittenWorksWithoutAnArchive() throws IOException {
    String java = fakeJava("one", FORGER);
    assertTrue(application.toFile().setWritable(false));
    assumeFalse(Files.isWritable(application), "this user may write everywhere");
    assertVersionAlone(version(java));
    assertTrue(application.toFile().setWritable(true));
    assertEquals(List.of(), leftOvers());
  }

  @ParameterizedTest
  @ValueSource(strings = {"1k", "7m", "1000000", "900t", "4x", "-1g", "1.5g", "0"})
  void memoryThatJavaCannotHaveIsWrongUsage(String memory) throws IOException {
    Program.Ended ended = ended("launched", start(fakeJava("one", FORGER), "launched", memory));
    ended.expect(2).says("eventchain: EVENTCHAIN_MEMORY is '" + memory + "'; ");
    assertEquals("", ended.out());
  }

  static List<String> memory() {
    return Thorough.allOrOne(List.of("65536k", "64m", "1g", "67108864"));
  }

  @ParameterizedTest
  @MethodSource("memory")
  void memoryHasAnyUnit(String memory) throws IOException {
    assertVersionAlone(ended("launched", start(fakeJava("one", FORGER), "launched", memory)));
  }

  @Test
  void onlyTheServerForEditorsLivesLongEnoughForBothCompilers() throws IOException {
    String java = fakeJava("one", FORGER + "echo \"$*\"; exit 0");
    String once = ended("once", start(java, "once", "", "validate", "lsp")).expect(0).out();
    assertTrue(once.contains("-XX:TieredStopAtLevel=1 "), once);
    String server = ended("server", start(java, "server", "", "lsp")).expect(0).out();
    assertFalse(server.contains("TieredStopAtLevel"), server);
    assertTrue(server.endsWith("dev.eventchain.cli.Main lsp\n"), server);
  }

  private long rehearsals() throws IOException {
    return Files.readAllLines(folder.resolve("calls")).size();
  }

  /** Returns a JDK whose {@code java} runs a script before that of this test. */
  private String fakeJava(String version, String first) throws IOException {
    Path jdk = folder.resolve("jdk-" + version);
    Path java = Files.createDirectories(jdk.resolve("bin")).resolve("java");
    Files.writeString(jdk.resolve("release"), "JAVA_RUNTIME_VERSION=\"" + version + "\"\n");
    Files.writeString(
        java,
        "#!/bin/sh\n"
            + first
            + "\nexec '"
            + System.getProperty("java.home")
            + "/bin/java' \"$@\"\n");
    assertTrue(java.toFile().setExecutable(true));
    return jdk.toString();
  }

  private static void assertVersionAlone(Program.Ended ended) {
    ended.expect(0);
    assertTrue(ended.out().matches("eventchain \\S+\n"), ended.out());
    assertEquals("", ended.err());
  }

  private Path archive() throws IOException {
    try (Stream<Path> files = Files.list(application)) {
      List<Path> archives = files.filter(f -> f.toString().endsWith(".jsa")).toList();
      assertEquals(1, archives.size(), archives.toString());
      return archives.get(0);
    }
  }

  private List<Path> leftOvers() throws IOException {
    try (Stream<Path> files = Files.list(application)) {
      return files.filter(f -> f.getFileName().toString().startsWith("archive.")).toList();
    }
  }

  /**
   * Returns the classes that a small command loads, each with its source, when Java must use the
   * archive.
   */
  private String loadedFrom(Path archive) throws IOException {
    Path log = folder.resolve("loaded");
    String classPath;
    try (Stream<Path> jars = Files.list(application.resolve("lib"))) {
      classPath = jars.map(Path::toString).sorted().collect(Collectors.joining(":"));
    }
    Process java =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xshare:on",
                "-XX:+UseSerialGC",
                "-XX:SharedArchiveFile=" + archive,
                "-Xlog:class+load:file=loaded",
                "-cp",
                classPath,
                "dev.eventchain.cli.Main",
                "--version")
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    assertEquals(0, java.onExit().join().exitValue(), "the archive cannot be mapped");
    return Files.readString(log);
  }

  private Program.Ended version() throws IOException {
    return version(System.getProperty("java.home"));
  }

  private Program.Ended version(String javaHome) throws IOException {
    return ended("launched", start(javaHome, "launched"));
  }

  private Process start(String javaHome, String name) throws IOException {
    return start(javaHome, name, "");
  }

  private Process start(String javaHome, String name, String memory) throws IOException {
    return start(javaHome, name, memory, "--version");
  }

  private Process start(String javaHome, String name, String memory, String... arguments)
      throws IOException {
    List<String> command = new ArrayList<>(List.of(home.resolve("eventchain").toString()));
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().put("JAVA_HOME", javaHome);
    builder.environment().put("EVENTCHAIN_MEMORY", memory);
    return builder
        .redirectOutput(folder.resolve(name + ".out").toFile())
        .redirectError(folder.resolve(name + ".err").toFile())
        .start();
  }

  private Program.Ended ended(String name, Process process) throws IOException {
    int code = process.onExit().join().exitValue();
    Program.Ended ended =
        new Program.Ended(
            code,
            Files.readString(folder.resolve(name + ".out")),
            Files.readString(folder.resolve(name + ".err")));
    assertFalse(ended.err().contains("warning"), ended.err());
    return ended;
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.filter(f -> !f.startsWith(from.resolve("out"))).toList()) {
        Path target = to.resolve(from.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(target);
        } else {
          Files.createDirectories(target.getParent());
          Files.copy(file, target, java.nio.file.StandardCopyOption.COPY_ATTRIBUTES);
        }
      }
    }
  }
}
