package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.generate.GeneratedPackage;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.ComponentSources;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.ComponentMutant;
import dev.eventchain.sandbox.ComponentMutator;
import dev.eventchain.simulation.node.NodeManifest;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedSet;
import java.util.function.Predicate;

/** The mutants of all components and nodes that a project's chain executes. */
final class ProjectMutants {

  private ProjectMutants() {}

  /** Returns the nodes that are simulated, in the order of the chain. */
  static List<SoftwareNode> nodes(RunContext run) {
    NodeManifest manifest = GeneratedPackage.required(run).manifest();
    return run.chain().chain().getSoftware().stream()
        .filter(node -> manifest.find(node.getName()).isPresent())
        .toList();
  }

  /** Returns those of the simulated nodes that are hosted as they are. */
  static List<SoftwareNode> hosted(RunContext run) {
    NodeManifest manifest = GeneratedPackage.required(run).manifest();
    return nodes(run).stream()
        .filter(node -> manifest.find(node.getName()).orElseThrow().component().isEmpty())
        .toList();
  }

  /** Returns the modules of the project that simulated components import, without their files. */
  static SortedSet<Path> modules(RunContext run, Predicate<String> chosen) {
    List<SoftwareBase.Component> existing =
        nodes(run).stream()
            .filter(node -> chosen.test(node.getName()))
            .flatMap(node -> run.softwareBase().find(node.getName()).stream())
            .toList();
    return ComponentSources.modules(existing);
  }

  /**
   * Returns all mutants, in the order of the chain and of their places.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if a file cannot be parsed
   */
  static List<Mutant> of(RunContext run, ComponentMutator mutator) {
    NodeManifest manifest = GeneratedPackage.required(run).manifest();
    List<Mutant> mutants = new ArrayList<>();
    for (SoftwareNode node : nodes(run)) {
      NodeManifest.Node simulated = manifest.find(node.getName()).orElseThrow();
      Path file = ComponentFiles.of(run, node);
      SourceText source = SourceText.read(file);
      defects(node, simulated, source, mutator)
          .forEach(
              defect ->
                  mutants.add(
                      new Mutant(
                          node.getName(), file, source, defect, simulated.component().isEmpty())));
    }
    return mutants;
  }

  private static List<ComponentMutant> defects(
      SoftwareNode node, NodeManifest.Node simulated, SourceText source, ComponentMutator mutator) {
    if (simulated.component().isEmpty()) {
      return mutator.ofNode(source, simulated.className());
    }
    NodeManifest.Component component = simulated.component().get();
    return mutator.mutants(
        source, component.className(), swaps(node, component), outputs(component));
  }

  /** Returns the pairs of inputs of the same type and unit. */
  private static List<ComponentMutator.Pair> swaps(
      SoftwareNode node, NodeManifest.Component component) {
    List<String> names = component.inputs();
    List<ComponentMutator.Pair> pairs = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      Optional<Data> first = input(node, names.get(i));
      for (int k = i + 1; k < names.size(); k++) {
        Optional<Data> second = input(node, names.get(k));
        if (first.isPresent() && second.isPresent() && isAlike(first.get(), second.get())) {
          pairs.add(new ComponentMutator.Pair(names.get(i), names.get(k)));
        }
      }
    }
    return pairs;
  }

  private static Optional<Data> input(SoftwareNode node, String name) {
    return node.getInput().stream().filter(data -> name.equals(data.getName())).findFirst();
  }

  private static boolean isAlike(Data one, Data other) {
    return one.getType() != null
        && one.getType().equals(other.getType())
        && unit(one).equals(unit(other));
  }

  private static String unit(Data data) {
    return Objects.requireNonNullElse(data.getUnit(), "").strip();
  }

  private static List<ComponentMutator.Output> outputs(NodeManifest.Component component) {
    return component.outputs().stream()
        .map(each -> new ComponentMutator.Output(each.name(), isSingle(each.type())))
        .toList();
  }

  /** An output of unknown type may be an array, which has no truth value. */
  private static boolean isSingle(String type) {
    return !type.isEmpty() && !type.contains("[") && !type.contains("<");
  }
}
