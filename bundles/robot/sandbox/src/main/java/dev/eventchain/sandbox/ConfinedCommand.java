package dev.eventchain.sandbox;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;

/** The command line of a confined process: bubblewrap (where used), Python, and confined.py. */
final class ConfinedCommand {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String START =
      "import sys; sys.path.insert(0, sys.argv[1]); import confined; confined.main(sys.argv[2])";
  private static final long MIB = 1024 * 1024;
  private static final long FILE_SIZE = 64 * MIB;
  private static final int OPEN_FILES = 256;

  private final PythonEnvironment environment;
  private final Path harness =
      PythonSources.unpack(ConfinedCommand.class.getClassLoader(), "dev/eventchain/sandbox");
  private final List<Path> readable = new ArrayList<>();
  private final List<Path> pythonPath = new ArrayList<>();
  private List<String> arguments = List.of();
  private String programKind = "";
  private String program = "";
  private Path workFolder;
  private ConfinedProcess.Limits limits;
  private Confinement confinement;
  private boolean kernel = true;
  private boolean hooks = true;
  private boolean components;
  private int turn;
  private int hashSeed;
  private JsonNode preparation;

  ConfinedCommand(PythonEnvironment environment) {
    this.environment = environment;
  }

  void program(String kind, String name) {
    programKind = kind;
    program = name;
  }

  void arguments(List<String> values) {
    arguments = values;
  }

  void workFolder(Path folder) {
    workFolder = folder.toAbsolutePath().normalize();
  }

  void readable(Collection<Path> paths) {
    paths.forEach(path -> readable.add(path.toAbsolutePath().normalize()));
  }

  void pythonPath(Collection<Path> folders) {
    folders.forEach(folder -> pythonPath.add(folder.toAbsolutePath().normalize()));
  }

  void limits(ConfinedProcess.Limits newLimits) {
    limits = newLimits;
  }

  void confinement(Confinement chosen) {
    confinement = chosen;
  }

  void components(int newTurn) {
    components = true;
    turn = newTurn;
    pythonPath.add(harness);
  }

  void preparation(String module, JsonNode settings) {
    ObjectNode described = JSON.createObjectNode();
    described.put("module", module).set("settings", settings);
    preparation = described;
  }

  void hashSeed(int seed) {
    hashSeed = seed;
  }

  void withoutKernel() {
    kernel = false;
  }

  void withoutHooks() {
    hooks = false;
  }

  /** Returns the complete environment of the process. */
  Map<String, String> settings() {
    return Map.of(
        "HOME", workFolder.toString(),
        "TMPDIR", workFolder.toString(),
        "LC_ALL", "C.UTF-8",
        "PYTHONUTF8", "1",
        "PYTHONHASHSEED", Integer.toString(hashSeed),
        "PYTHONDONTWRITEBYTECODE", "1",
        "PYTHONNOUSERSITE", "1",
        "PYTHONSAFEPATH", "1",
        "OPENBLAS_NUM_THREADS", "1");
  }

  List<String> line() {
    Objects.requireNonNull(workFolder, "a confined process needs a work folder");
    Bytecode.compile(environment, harness);
    pythonPath.forEach(folder -> Bytecode.compile(environment, folder));
    Confinement chosen = confinement == null ? Confinement.detect() : confinement;
    List<String> line = new ArrayList<>();
    if (chosen == Confinement.BUBBLEWRAP) {
      List<Path> visible = new ArrayList<>(environment.installation());
      visible.add(harness);
      visible.addAll(pythonPath);
      visible.addAll(readable);
      line.addAll(Bubblewrap.command(visible, workFolder, preparation != null));
    }
    line.add(environment.executable().toString());
    line.addAll(List.of("-c", START, harness.toString(), description(chosen)));
    return line;
  }

  private String description(Confinement chosen) {
    ObjectNode description = JSON.createObjectNode();
    description.put("work", workFolder.toString());
    description.put(programKind, program);
    addAll(description.putArray("readable"), readable.stream());
    addAll(description.putArray("path"), pythonPath.stream());
    addAll(description.putArray("arguments"), arguments.stream());
    ObjectNode amounts = description.putObject("limits");
    amounts.put("cpuSeconds", Math.max(1, limits.cpuTime().plusMillis(999).toSeconds()));
    amounts.put("memory", limits.memoryMiB() * MIB);
    amounts.put("fileSize", FILE_SIZE);
    amounts.put("openFiles", OPEN_FILES);
    description.put("enclosed", chosen == Confinement.BUBBLEWRAP);
    description.put("kernel", kernel);
    description.put("hooks", hooks);
    description.put("components", components);
    description.put("turn", turn);
    description.put("parent", ProcessHandle.current().pid());
    if (preparation != null) {
      description.set("preparation", preparation);
    }
    return description.toString();
  }

  private static void addAll(ArrayNode array, Stream<?> values) {
    values.forEach(value -> array.add(value.toString()));
  }
}
