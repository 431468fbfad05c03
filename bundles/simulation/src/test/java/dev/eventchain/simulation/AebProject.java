package dev.eventchain.simulation;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.python.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EPackage;

/**
 * The AEB example with nodes generated for it and hand-written components in the place of those
 * that a language model writes, in a folder where tests can change components.
 */
final class AebProject {

  private static final Path RESOURCES = Path.of("src/test/resources");
  static final Path EXAMPLE = Path.of("../../examples/aeb");
  static final Bench BENCH = Bench.carla();

  private final Path folder;
  private final EventChain chain;

  AebProject(Path folder) throws IOException {
    this(folder, load(), Generated.FILES);
  }

  private AebProject(Path folder, EventChain chain, Map<String, byte[]> files) throws IOException {
    this.folder = folder;
    this.chain = chain;
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      Path target = folder.resolve(file.getKey());
      Files.createDirectories(target.getParent());
      Files.write(target, file.getValue());
    }
    copyComponents(RESOURCES.resolve("aeb/components"));
    copyComponents(EXAMPLE.resolve("software-base/components"));
  }

  /** The project with the nodes of another chain of the same components. */
  static AebProject of(Path folder, Consumer<EventChain> change) throws IOException {
    EventChain chain = load();
    change.accept(chain);
    return new AebProject(folder, chain, Generated.filesOf(chain));
  }

  private void copyComponents(Path from) throws IOException {
    try (Stream<Path> files = Files.list(from)) {
      for (Path file : files.filter(file -> file.toString().endsWith(".py")).toList()) {
        String name = file.getFileName().toString();
        Files.copy(file, component(name.substring(0, name.length() - ".py".length())));
      }
    }
  }

  private static EventChain load() {
    XmiStore store = new XmiStore(RESOURCES.resolve("aeb"));
    return (EventChain)
        store.load(RESOURCES.resolve("aeb/chain.xmi")).resource().getContents().get(0);
  }

  /** The nodes are generated once: a template is compiled in a second. */
  private static final class Generated {
    private static final TemplateModule MODULE =
        TemplateModule.compile(
            Path.of("../../templates/ros2-python/main.mtl"),
            List.of(EventchainPackage.eINSTANCE, messages()));
    private static final Map<String, byte[]> FILES = filesOf(load());

    /** The metamodel of message definitions, which the templates name. */
    private static EPackage messages() {
      Path folder = Path.of("../../metamodel");
      return new XmiStore(folder).loadMetamodel(folder.resolve("messages.ecore")).get(0);
    }

    private static Map<String, byte[]> filesOf(EventChain chain) {
      return MODULE.generate(List.of(chain), element -> SourceLocation.NONE).files();
    }
  }

  /** The chain; tests may change it. */
  EventChain chain() {
    return chain;
  }

  /** Where the file of a component is. */
  Path component(String name) {
    return folder.resolve("aeb/aeb/components").resolve(name + ".py");
  }

  /** Replaces a component by another file of the test resources. */
  AebProject with(String component, String file) throws IOException {
    Files.writeString(component(component), Files.readString(RESOURCES.resolve(file)));
    return this;
  }

  static List<Scenario> scenarios() {
    return Scenario.readFolder(EXAMPLE.resolve("scenarios"), BENCH, warning -> {});
  }

  static Scenario scenario(String name) {
    return scenarios().stream().filter(s -> s.name().equals(name)).findFirst().orElseThrow();
  }

  SimulationRequest request(List<Scenario> scenarios) {
    List<Path> messages = List.of(EXAMPLE.resolve("software-base/msg"));
    return SimulationRequest.of(
        chain, folder.resolve("aeb"), manifest(), messages, BENCH, scenarios);
  }

  NodeManifest manifest() {
    return NodeManifest.read(SourceText.read(folder.resolve("aeb").resolve(NodeManifest.FILE)));
  }

  SimulationResult simulate(List<Scenario> scenarios) throws InterruptedException {
    return simulate(request(scenarios));
  }

  static SimulationResult simulate(SimulationRequest request) throws InterruptedException {
    return Simulation.run(request, PythonEnvironment.ensure(line -> {}), verdict -> {});
  }
}
