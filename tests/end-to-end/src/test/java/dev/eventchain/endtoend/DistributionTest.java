package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the unpacked distribution works as in the repository and stays unchanged. */
class DistributionTest {

  private static final Path AGAIN = Program.ROOT.resolve("bundles/front/distribution/target/again");

  @TempDir static Path folder;
  private static Installation installation;
  private static SortedMap<String, String> unpacked;

  @BeforeAll
  static void unpack() throws IOException {
    installation = new Installation(folder);
    unpacked = installation.content();
  }

  @AfterAll
  static void nothingInItHasChanged() throws IOException {
    SortedMap<String, String> now = installation.content();
    installation.mayBeRemoved();
    assertEquals(unpacked, now);
  }

  @Test
  void examplesRunWithoutCompilerAndMaven() throws IOException {
    Map<String, String> python = python();
    for (String name : Thorough.allOrFirst(List.of("radar-aeb", "aeb"))) {
      Path example = folder.resolve("my " + name);
      Projects.copy(installation.home().resolve("examples/" + name), example);
      makeWritable(example);
      Projects.withoutStrength(example);
      run(python, "run", example, "--no-strength").expect(0).says("PASSED: ");
      run(python, "validate", example).expect(0).says("constraints evaluated");
    }
  }

  @InTurn
  @Test
  void doctorSaysBeforeARunThatItCannotWork() throws IOException {
    Path nowhere = folder.resolve("wheels");
    Path cache = Files.createDirectory(folder.resolve("cache without Python"));
    Map<String, String> settings =
        Map.of(
            "XDG_CACHE_HOME",
            cache.toString(),
            "EVENTCHAIN_WHEELS",
            nowhere.toString(),
            "PATH",
            System.getenv("PATH"));
    String words = "EVENTCHAIN_WHEELS names " + nowhere + ", which is not a folder";
    String out = run(settings, "doctor").expect(3).out();
    assertTrue(out.lines().anyMatch(line -> line.matches("Python +missing +" + words + ".*")), out);
  }

  @Test
  void anExampleThatCannotBeWrittenIsNamed() throws IOException {
    Path cache = Files.createDirectory(folder.resolve("cache of nobody"));
    for (Path path : List.of(folder, cache)) {
      Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("rwxrwxrwx"));
    }
    boolean isRoot = Files.isWritable(installation.home());
    List<String> asNobody = List.of("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups");
    Path example = installation.home().resolve("examples/aeb");
    installation
        .run(
            isRoot ? asNobody : List.of(),
            Map.of("XDG_CACHE_HOME", cache.toString()),
            "validate",
            example)
        .expect(2)
        .says(example + "/out: error: The output cannot be written: permission is denied.")
        .says("choose another folder with -o");
  }

  @Test
  void archivesOfClassesAreKeptInTheCacheForThisBuildAndPlace() throws IOException {
    Path jdk = folder.resolve("jdk");
    Files.createDirectories(jdk.resolve("bin"));
    Files.writeString(
        jdk.resolve("release"), "JAVA_VERSION=\"17.0.15\"\nJAVA_RUNTIME_VERSION=\"17\"\n");
    Installation.script(
        jdk.resolve("bin/java"),
        LauncherTest.FORGER + "exec '" + Installation.realJava() + "' \"$@\"");
    Path cache = Files.createDirectory(folder.resolve("cache of archives"));
    Map<String, String> settings =
        Map.of("JAVA_HOME", jdk.toString(), "XDG_CACHE_HOME", cache.toString());
    run(settings, "--version").expect(0);
    run(settings, "--version").expect(0);
    assertEquals(1, Files.readAllLines(folder.resolve("calls")).size());
    try (Stream<Path> files = Files.walk(cache)) {
      Path named =
          files.filter(file -> file.toString().endsWith(".jsa.home")).findFirst().orElseThrow();
      String build = Files.readString(installation.home().resolve("lib/build")).strip();
      assertEquals(build + " " + installation.home() + "\n", Files.readString(named));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"11.0.2", "1.8.0_392", "16"})
  void anOldJavaIsRefused(String version) throws IOException {
    Path jdk = folder.resolve("jdk-" + version);
    Files.createDirectories(jdk.resolve("bin"));
    Files.writeString(jdk.resolve("release"), "JAVA_VERSION=\"" + version + "\"\n");
    Installation.script(jdk.resolve("bin/java"), "echo started");
    String number = version.replaceFirst("^1\\.", "");
    Program.Ended ended = run(Map.of("JAVA_HOME", jdk.toString()), "--version").expect(3);
    assertEquals("", ended.out());
    assertEquals(
        "eventchain: Java "
            + number
            + " is too old. Install Java, version 17 or later, or set JAVA_HOME to one.\n",
        ended.err());
  }

  @Test
  void everyCommandHasAPageAndIsCompleted() throws IOException {
    List<String> commands = new ArrayList<>();
    boolean listed = false;
    for (String line : run(Map.of(), "--help").expect(0).out().lines().toList()) {
      if (listed && line.matches(" {2}[a-z]+ .*")) {
        commands.add(line.strip().replaceFirst(" .*", ""));
      }
      listed |= line.startsWith("Commands:");
    }
    assertTrue(commands.contains("run") && commands.contains("doctor"), commands.toString());
    String main = Files.readString(installation.home().resolve("man/man1/eventchain.1"));
    for (String command : commands) {
      assertTrue(main.contains("eventchain\\-" + command + "(1)"), command);
      String page = page(command);
      assertTrue(page.contains("\n.SH OPTIONS\n.TP\n.B \\-"), page);
    }
    assertTrue(page("run").contains("\n.B \\-\\-scenario=NAME\n"), page("run"));
    assertEquals("simulate", completed("eventchain", "sim"));
    assertEquals("--overwrite", completed("eventchain", "run", "--overw"));
  }

  private static String page(String command) throws IOException {
    return Files.readString(installation.home().resolve("man/man1/eventchain-" + command + ".1"));
  }

  private static String completed(String... words) throws IOException {
    List<String> command = new ArrayList<>();
    Collections.addAll(
        command,
        "bash",
        "-c",
        "source \"$1\"; shift; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1));"
            + " _complete_eventchain; printf '%s' \"${COMPREPLY[*]}\"",
        "bash",
        installation.home().resolve("completion/eventchain.bash").toString());
    Collections.addAll(command, words);
    Process bash = new ProcessBuilder(command).start();
    return new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
  }

  @Test
  void twoPackingsHaveTheSameBytesAndNoneOfThisBuild() throws IOException {
    Path zip = Installation.zip();
    assertEquals(-1, Files.mismatch(zip, AGAIN.resolve(zip.getFileName())));
    Set<String> times = new TreeSet<>();
    List<String> names = new ArrayList<>();
    try (ZipFile file = new ZipFile(zip.toFile())) {
      for (ZipEntry entry : file.stream().toList()) {
        times.add(entry.getTimeLocal().toString());
        if (!entry.isDirectory()) {
          names.add(entry.getName());
        }
      }
    }
    assertEquals(1, times.size(), times.toString());
    assertTrue(names.stream().noneMatch(name -> name.matches(".*/(out|__pycache__)/.*")));
    String root = names.get(0).replaceFirst("/.*", "/");
    assertTrue(names.stream().allMatch(name -> name.startsWith(root)));
  }

  @Test
  void ownJarsHoldNoTimeOfTheirBuild() throws IOException {
    for (Path jar : jars()) {
      if (jar.getFileName().toString().startsWith("eventchain-")) {
        try (ZipFile file = new ZipFile(jar.toFile())) {
          Set<String> times =
              file.stream()
                  .map(entry -> entry.getTimeLocal().toString())
                  .collect(Collectors.toSet());
          assertEquals(1, times.size(), jar + " " + times);
        }
      }
    }
  }

  @Test
  void billOfMaterialsAndLicencesNameEachJar() throws IOException {
    boolean isOffline = System.getProperty("maven.mode", "").equals("offline=true");
    assumeFalse(isOffline, "offline, the plugin makes no bill");
    JsonNode bill =
        new ObjectMapper().readTree(installation.home().resolve("sbom.cdx.json").toFile());
    assertEquals("CycloneDX", bill.path("bomFormat").asText());
    assertTrue(bill.path("serialNumber").isMissingNode(), "a number of its own for each build");
    assertTrue(bill.at("/metadata/timestamp").isMissingNode(), "the time of the build");
    Set<String> billed = new TreeSet<>();
    for (JsonNode component : bill.path("components")) {
      billed.add(component.path("name").asText() + "-" + component.path("version").asText());
    }
    Set<String> present = new TreeSet<>();
    String licences = Files.readString(installation.home().resolve("THIRD-PARTY.txt"));
    for (Path jar : jars()) {
      String name = jar.getFileName().toString().replaceFirst("\\.jar$", "");
      present.add(name);
      if (!name.startsWith("eventchain-")) {
        String artifact = name.replaceFirst("-[0-9].*", "");
        assertTrue(licences.contains(":" + artifact + ":"), name);
      }
    }
    assertEquals(present, billed);
  }

  private static List<Path> jars() throws IOException {
    try (Stream<Path> files = Files.list(installation.home().resolve("lib"))) {
      return files.filter(file -> file.toString().endsWith(".jar")).sorted().toList();
    }
  }

  /** Returns this user's Python packages, which a run would otherwise download again. */
  private static Map<String, String> python() throws IOException {
    String configured = System.getenv().getOrDefault("XDG_CACHE_HOME", "");
    Path user =
        configured.isEmpty()
            ? Path.of(System.getProperty("user.home"), ".cache")
            : Path.of(configured);
    Path known = Files.createDirectories(installation.cache().resolve("eventchain"));
    try (Stream<Path> files = Files.list(user.resolve("eventchain"))) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        if (file.getFileName().toString().startsWith("python-of-")) {
          Files.copy(file, known.resolve(file.getFileName()));
        }
      }
    }
    String chosen = System.getenv().getOrDefault("EVENTCHAIN_PYTHON", "");
    return Map.of(
        "EVENTCHAIN_PYTHON", chosen.isEmpty() ? Installation.onPath("python3").toString() : chosen);
  }

  private static void makeWritable(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.toList()) {
        assertTrue(file.toFile().setWritable(true, true));
      }
    }
  }

  private static Program.Ended run(Map<String, String> settings, Object... arguments)
      throws IOException {
    return installation.run(List.of(), settings, arguments);
  }
}
