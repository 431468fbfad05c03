package dev.eventchain.simulation;

import static dev.eventchain.diagnostics.SourceLocation.NONE;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.QosProfile;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.node.NodeManifest;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EPackage;

/**
 * The AEB example with generated nodes, and hand-written components in place of those by a language
 * model, in a folder where tests can change components.
 */
public final class AebProject {

  private static final Path RESOURCES =
      Repository.ROOT.resolve("bundles/robot/simulation/src/test/resources");
  public static final Path EXAMPLE = Repository.ROOT.resolve("examples/aeb");
  public static final Bench BENCH = bench(declared());

  private static final Set<String> SCENARIOS =
      Set.of(
          "braking-vehicle",
          "empty-road",
          "next-lane",
          "receding-vehicle",
          "same-speed-vehicle",
          "slow-approach",
          "slower-vehicle",
          "stopped-vehicle-20",
          "stopped-vehicle-50",
          "stopped-vehicle-60");

  private final Path folder;
  private final EventChain chain;

  public AebProject(Path folder) throws IOException {
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

  /** Returns the example's bench with other descriptions of its topics. */
  public static Bench bench(List<Signal> declared) {
    return Bench.read(
        Optional.of(EXAMPLE.resolve("bench.yaml")),
        declared,
        MessageCatalog.of(List.of(messages())));
  }

  private static Path messages() {
    return EXAMPLE.resolve("software-base/msg");
  }

  /** Returns the topics that formulas of the example's scenarios read, with their units. */
  public static List<Signal> declared() {
    List<Signal> signals = new ArrayList<>();
    SourceText text = SourceText.read(EXAMPLE.resolve("software-base/signals.json"));
    try {
      for (JsonNode topic : new ObjectMapper().readTree(text.text())) {
        List<Signal.Field> fields = new ArrayList<>();
        for (JsonNode field : topic.get("Message Definition")) {
          String unit = field.path("Unit").asText("");
          String type = field.get("Type").asText();
          fields.add(new Signal.Field(field.get("Field").asText(), type, unit, NONE));
        }
        String direction = topic.get("direction").asText().toUpperCase(Locale.ROOT);
        signals.add(
            new Signal(
                topic.get("Topic Name").asText(),
                topic.get("Message Type").asText(),
                Signal.Direction.valueOf(direction),
                Optional.of(profile(topic.get("qos_profile").asText())),
                fields,
                NONE));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return signals;
  }

  private static QosProfile profile(String name) {
    QosProfile profile = EventchainFactory.eINSTANCE.createQosProfile();
    profile.setName(name);
    return profile;
  }

  /** Returns the project with the nodes of another chain of the same components. */
  public static AebProject of(Path folder, Consumer<EventChain> change) throws IOException {
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
    XmiStore store = EventChainMetamodel.store(RESOURCES.resolve("aeb"));
    return (EventChain)
        store.load(RESOURCES.resolve("aeb/chain.xmi")).resource().getContents().get(0);
  }

  /** Nodes generated once for all tests, since compiling a template takes a second. */
  private static final class Generated {
    private static final TemplateModule MODULE =
        TemplateModule.compile(
            Repository.ROOT.resolve("templates/ros2-python/main.mtl"),
            List.of(EventchainPackage.eINSTANCE, messages()));
    private static final Map<String, byte[]> FILES = filesOf(load());

    /** Returns the metamodel of message definitions, which the templates name. */
    private static EPackage messages() {
      Path folder = Repository.ROOT.resolve("metamodel");
      return EventChainMetamodel.store(folder)
          .loadMetamodel(folder.resolve("messages.ecore"))
          .get(0);
    }

    private static Map<String, byte[]> filesOf(EventChain chain) {
      return MODULE.generate(List.of(chain), element -> SourceLocation.NONE).files();
    }
  }

  /** Returns the chain; tests may change it. */
  public EventChain chain() {
    return chain;
  }

  /** Returns the file of a component. */
  public Path component(String name) {
    return folder.resolve("aeb/aeb/components").resolve(name + ".py");
  }

  /** Replaces a component by a file of the test resources of the module that runs. */
  AebProject with(String component, String file) throws IOException {
    Path replacement = Path.of("src/test/resources").resolve(file);
    Files.writeString(component(component), Files.readString(replacement));
    return this;
  }

  /** Returns some of the example's scenarios: enough for these tests, and fast to simulate. */
  public static List<Scenario> scenarios() {
    return Scenario.readFolder(EXAMPLE.resolve("scenarios"), BENCH, warning -> {}).stream()
        .filter(each -> SCENARIOS.contains(each.name()))
        .toList();
  }

  public static Scenario scenario(String name) {
    return scenarios().stream().filter(s -> s.name().equals(name)).findFirst().orElseThrow();
  }

  public SimulationRequest request(List<Scenario> scenarios) {
    return request(scenarios, BENCH);
  }

  /** Returns a request with another bench. */
  public SimulationRequest request(List<Scenario> scenarios, Bench bench) {
    return SimulationRequest.of(
        chain,
        folder.resolve("aeb"),
        manifest(),
        MessageCatalog.of(List.of(messages())),
        bench,
        scenarios);
  }

  public NodeManifest manifest() {
    return NodeManifest.read(SourceText.read(folder.resolve("aeb").resolve(NodeManifest.FILE)));
  }

  public SimulationResult simulate(List<Scenario> scenarios) throws InterruptedException {
    return simulate(request(scenarios));
  }

  public static SimulationResult simulate(SimulationRequest request) throws InterruptedException {
    return Simulation.run(request, PythonEnvironment.ensure(line -> {}), verdict -> {});
  }
}
