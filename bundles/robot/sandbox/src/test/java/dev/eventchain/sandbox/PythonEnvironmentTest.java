package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

class PythonEnvironmentTest {

  @TempDir Path folder;

  @Test
  void hasThePinnedPackages() throws Exception {
    Process process =
        new ProcessBuilder(
                TestEnvironment.PYTHON.executable().toString(),
                "-c",
                "import importlib.metadata as m, sys;"
                    + "print('.'.join(map(str, sys.version_info[:3])), m.version('ruamel.yaml'))")
            .start();
    String output = process.inputReader(StandardCharsets.UTF_8).readLine();
    assertEquals(TestEnvironment.PYTHON.version() + " 0.19.1", output);
  }

  @Test
  void isFoundAgainWithoutStartingPython() throws IOException {
    Path log = folder.resolve("log");
    Path python = script("python3", "echo started >> " + log + "\nexec python3 \"$@\"");
    Map<String, String> settings = settings(Map.of("EVENTCHAIN_PYTHON", python.toString()));
    settings.put("XDG_CACHE_HOME", CacheFolder.of(System.getenv()).getParent().toString());
    Path first = find(settings).executable();
    Files.deleteIfExists(log);
    assertEquals(first, find(settings).executable());
    assertTrue(Files.notExists(log), "Python was started");
  }

  @Test
  void missingPythonIsNamed() {
    Diagnostic none = failure(settings(Map.of("PATH", folder.toString())));
    assertEquals("There is no python3 on the PATH.", none.message());
    Diagnostic wrong = failure(settings(Map.of("EVENTCHAIN_PYTHON", "/no/such/python")));
    assertTrue(wrong.message().contains("/no/such/python"), wrong.message());
    assertTrue(wrong.hint().contains("3.10"), wrong.hint());
  }

  @Test
  void problemAndHintOfTheScriptAreReported() throws IOException {
    Path old =
        script(
            "python3", "echo 'error: Python 3.7 is too old' >&2; echo 'hint: newer' >&2; exit 3");
    Diagnostic problem = failure(settings(Map.of("EVENTCHAIN_PYTHON", old.toString())));
    assertEquals("Python 3.7 is too old", problem.message());
    assertEquals("newer", problem.hint());
  }

  @Test
  void cacheThatCannotBeWrittenIsNamed() {
    Diagnostic problem = failure(settings(Map.of("XDG_CACHE_HOME", "/proc/nowhere")));
    assertTrue(problem.message().contains("/proc/nowhere/eventchain"), problem.message());
    assertTrue(problem.hint().contains("XDG_CACHE_HOME"), problem.hint());
  }

  @Test
  void pythonWithoutVenvSaysWhatToInstall() throws IOException {
    Path python = script("python3", "exec python3 -c \"" + WITHOUT_VENV + "\" \"$@\"");
    Diagnostic problem =
        failure(
            settings(
                Map.of(
                    "EVENTCHAIN_PYTHON", python.toString(), "XDG_CACHE_HOME", folder + "/cache")));
    assertTrue(problem.message().contains("venv"), problem.message());
    assertTrue(problem.hint().contains("apt-get install python3-venv"), problem.hint());
  }

  @Test
  void cycloneDdsIsInAnEnvironmentOfItsOwn() throws Exception {
    PythonEnvironment with = PythonEnvironment.ensureWithCycloneDds(line -> {});
    Path library = with.cycloneDds().orElseThrow();
    assertTrue(library.getFileName().toString().startsWith("libddsc"), library.toString());
    Process process =
        new ProcessBuilder(
                with.executable().toString(),
                "-c",
                "import ctypes, sys; library = ctypes.CDLL(sys.argv[1]);"
                    + "library.dds_strretcode.restype = ctypes.c_char_p;"
                    + "print(library.dds_strretcode(-3).decode())",
                library.toString())
            .start();
    assertEquals("Bad Parameter", process.inputReader(StandardCharsets.UTF_8).readLine());
    assertEquals(Optional.empty(), TestEnvironment.PYTHON.cycloneDds());
    assertNotEquals(TestEnvironment.PYTHON.executable(), with.executable());
  }

  @InTurn
  @Test
  void cycloneDdsThatCannotBeHadIsNamed() throws IOException {
    Path other = Files.writeString(folder.resolve("constraint"), "cyclonedds==0.10.2\n");
    Map<String, String> settings =
        settings(Map.of("XDG_CACHE_HOME", folder + "/cache", "PIP_CONSTRAINT", other.toString()));
    EnvironmentFinder finder = new EnvironmentFinder(settings, line -> {});
    Diagnostic problem = failure("dds.unavailable", finder::findWithCycloneDds);
    assertTrue(problem.message().contains("Cyclone DDS cannot be installed"), problem.message());
    assertTrue(problem.hint().contains("x86_64"), problem.hint());
  }

  @InTurn
  @Test
  void rayThatCannotBeHadIsNamed() throws IOException {
    Path other = Files.writeString(folder.resolve("constraint"), "ray==2.9.0\n");
    Map<String, String> settings =
        settings(Map.of("XDG_CACHE_HOME", folder + "/cache", "PIP_CONSTRAINT", other.toString()));
    EnvironmentFinder finder = new EnvironmentFinder(settings, line -> {});
    Diagnostic problem = failure("ray.unavailable", finder::findWithRay);
    assertTrue(problem.message().startsWith("Ray cannot be installed"), problem.message());
    assertTrue(problem.hint().contains("PIP_INDEX_URL"), problem.hint());
  }

  @InTurn
  @Test
  void packagesComeFromAFolderOfWheelsAndFromNowhereElse() throws IOException {
    Path wheels = Files.createDirectories(folder.resolve("wheels"));
    for (String requirement : requirements()) {
      String[] pinned = requirement.replaceFirst(";.*", "").split("==", -1);
      writeEmptyWheel(wheels, pinned[0], pinned[1]);
    }
    Map<String, String> settings =
        settings(
            Map.of("XDG_CACHE_HOME", folder + "/cache", "EVENTCHAIN_WHEELS", wheels.toString()));
    EnvironmentFinder finder = new EnvironmentFinder(settings, line -> {});
    String version = TestEnvironment.PYTHON.version();
    assertEquals(
        version + ", packages will be installed from " + wheels.toRealPath() + " at the first use",
        finder.outlook());
    assertTrue(finder.find().executable().startsWith(folder.resolve("cache")));
    assertEquals(version + ", packages are there", finder.outlook());

    Files.delete(wheels.resolve("ruamel.yaml-0.19.1-py3-none-any.whl"));
    settings.put("XDG_CACHE_HOME", folder + "/another cache");
    Diagnostic problem = failure("python.wheels.missing", finder::outlook);
    assertTrue(problem.message().endsWith(" of ruamel.yaml==0.19.1"), problem.message());
    assertTrue(problem.hint().contains("--dest FOLDER ruamel.yaml==0.19.1;"), problem.hint());
  }

  @Test
  void aFolderOfWheelsThatDoesNotExistIsNamed() {
    Path nowhere = folder.resolve("nowhere");
    Map<String, String> settings =
        settings(
            Map.of("XDG_CACHE_HOME", folder + "/cache", "EVENTCHAIN_WHEELS", nowhere.toString()));
    Diagnostic problem = failure("python.wheels.missing", () -> find(settings));
    assertEquals(
        "EVENTCHAIN_WHEELS names " + nowhere + ", which is not a folder", problem.message());
  }

  private static List<String> requirements() throws IOException {
    try (var input = PythonEnvironment.class.getResourceAsStream("requirements.txt")) {
      String text = new String(input.readAllBytes(), StandardCharsets.UTF_8);
      return text.lines().filter(line -> !line.startsWith("#")).toList();
    }
  }

  /** Writes an empty wheel for any Python. */
  private static void writeEmptyWheel(Path wheels, String name, String version) throws IOException {
    String folder = name + "-" + version;
    String metadata = "Metadata-Version: 2.1\nName: " + name + "\nVersion: " + version + "\n";
    String wheel = "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n";
    Path file = wheels.resolve(folder + "-py3-none-any.whl");
    try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
      for (String[] entry :
          new String[][] {{"METADATA", metadata}, {"WHEEL", wheel}, {"RECORD", ""}}) {
        zip.putNextEntry(new ZipEntry(folder + ".dist-info/" + entry[0]));
        zip.write(entry[1].getBytes(StandardCharsets.UTF_8));
      }
    }
  }

  private static final String WITHOUT_VENV =
      "import runpy, sys; sys.argv = sys.argv[1:]; module = runpy.run_path(sys.argv[0]);"
          + "module['main'].__globals__['has_module'] = lambda name: name != 'venv';"
          + "module['os'].environ.pop('EVENTCHAIN_PYTHON', None);"
          + "sys.exit(module['main'](sys.argv[1:]))";

  private Path script(String name, String body) throws IOException {
    Path script = Files.writeString(folder.resolve(name), "#!/bin/sh\n" + body + "\n");
    assertTrue(script.toFile().setExecutable(true));
    return script;
  }

  private static Map<String, String> settings(Map<String, String> changes) {
    Map<String, String> settings = new LinkedHashMap<>(System.getenv());
    settings.remove("EVENTCHAIN_PYTHON");
    settings.putAll(changes);
    return settings;
  }

  private static PythonEnvironment find(Map<String, String> settings) {
    List<String> progress = new ArrayList<>();
    return new EnvironmentFinder(settings, progress::add).find();
  }

  private static Diagnostic failure(Map<String, String> settings) {
    return failure("python.unavailable", () -> find(settings));
  }

  private static Diagnostic failure(String id, Executable attempt) {
    DiagnosticException failure = assertThrows(DiagnosticException.class, attempt);
    assertEquals(DiagnosticException.Reason.UNAVAILABLE, failure.reason());
    assertEquals(id, failure.diagnostics().get(0).id());
    return failure.diagnostics().get(0);
  }
}
