package dev.eventchain.simulation;

import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.python.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.ResourceSet;
import org.eclipse.emf.ecore.resource.impl.ResourceSetImpl;
import org.eclipse.emf.ecore.xmi.impl.XMIResourceFactoryImpl;

/**
 * The AEB example with hand-written nodes and components in the place of the generated ones, in a
 * folder where tests can change components.
 */
final class AebProject {

  private static final Path RESOURCES = Path.of("src/test/resources");
  static final Path EXAMPLE = Path.of("../../examples/aeb");

  private final Path folder;
  private final EventChain chain;

  AebProject(Path folder) throws IOException {
    this.folder = folder;
    copy(RESOURCES.resolve("aeb/aeb"), folder.resolve("aeb"));
    copy(EXAMPLE.resolve("software-base/components"), folder.resolve("aeb/components"));
    this.chain = load(RESOURCES.resolve("aeb/chain.xmi"));
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        if (file.toString().endsWith(".py")) {
          Path target = to.resolve(from.relativize(file).toString());
          Files.createDirectories(target.getParent());
          Files.copy(file, target);
        }
      }
    }
  }

  private static EventChain load(Path file) throws IOException {
    ResourceSet resources = new ResourceSetImpl();
    resources.getPackageRegistry().put(EventchainPackage.eNS_URI, EventchainPackage.eINSTANCE);
    resources
        .getResourceFactoryRegistry()
        .getExtensionToFactoryMap()
        .put("xmi", new XMIResourceFactoryImpl());
    Resource resource = resources.createResource(URI.createFileURI(file.toString()));
    resource.load(null);
    return (EventChain) resource.getContents().get(0);
  }

  /** The chain; tests may change it. */
  EventChain chain() {
    return chain;
  }

  /** Where the file of a component is. */
  Path component(String name) {
    return folder.resolve("aeb/components").resolve(name + ".py");
  }

  /** Replaces a component by another file of the test resources. */
  AebProject with(String component, String file) throws IOException {
    Files.writeString(component(component), Files.readString(RESOURCES.resolve(file)));
    return this;
  }

  static List<Scenario> scenarios() {
    return Scenario.readFolder(EXAMPLE.resolve("scenarios"));
  }

  static Scenario scenario(String name) {
    return scenarios().stream().filter(s -> s.name().equals(name)).findFirst().orElseThrow();
  }

  SimulationRequest request(List<Scenario> scenarios) {
    List<Path> messages = List.of(EXAMPLE.resolve("software-base/msg"));
    return SimulationRequest.of(chain, folder, "aeb", messages, scenarios);
  }

  SimulationResult simulate(List<Scenario> scenarios) throws InterruptedException {
    return simulate(request(scenarios));
  }

  static SimulationResult simulate(SimulationRequest request) throws InterruptedException {
    return Simulation.run(request, PythonEnvironment.ensure(line -> {}), verdict -> {});
  }
}
