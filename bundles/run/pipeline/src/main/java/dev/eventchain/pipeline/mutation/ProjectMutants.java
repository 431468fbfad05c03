package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.ComponentUnits;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.generate.GeneratedPackage;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.ComponentMutant;
import dev.eventchain.sandbox.ComponentMutator;
import dev.eventchain.simulation.node.NodeManifest;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

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
  static ImportedModules modules(RunContext run) {
    return new ImportedModules(
        nodes(run).stream()
            .flatMap(node -> run.softwareBase().find(node.getName()).stream())
            .toList());
  }

  /**
   * Returns all mutants, in the order of the chain and of their places; then those of modules. What
   * two nodes of one file share has its mutants once.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if a file cannot be parsed
   */
  static List<Mutant> of(RunContext run, ComponentMutator mutator) {
    NodeManifest manifest = GeneratedPackage.required(run).manifest();
    Map<String, Mutant> mutants = new LinkedHashMap<>();
    for (SoftwareNode node : nodes(run)) {
      NodeManifest.Node simulated = manifest.find(node.getName()).orElseThrow();
      Path file = ComponentFiles.of(run, node);
      SourceText source = SourceText.read(file);
      boolean hosted = simulated.component().isEmpty();
      for (ComponentMutant defect : defects(node, simulated, source, mutator)) {
        Mutant mutant = mutant(node.getName(), file, source, defect, hosted);
        String key = (hosted ? file : node.getName()) + "\n" + defect.edits();
        mutants.merge(key, mutant, (first, same) -> first.alsoIn(node.getName()));
      }
    }
    List<Mutant> all = new ArrayList<>(mutants.values());
    addModules(run, mutator, all);
    return all;
  }

  private static Mutant mutant(
      String name, Path file, SourceText source, ComponentMutant defect, boolean hosted) {
    Mutant.Kind kind = hosted ? Mutant.Kind.NODE : Mutant.Kind.COMPONENT;
    Optional<String> tested = hosted ? Optional.empty() : Optional.of(name);
    return new Mutant(name, file, source, defect, kind, List.of(name), tested);
  }

  private static void addModules(RunContext run, ComponentMutator mutator, List<Mutant> mutants) {
    ImportedModules modules = modules(run);
    for (Path file : modules.files()) {
      SourceText source = SourceText.read(file);
      List<String> users = modules.users(file).stream().map(SoftwareBase.Component::name).toList();
      Optional<String> tested =
          modules.users(file).stream()
              .filter(user -> user.node().isEmpty())
              .map(SoftwareBase.Component::name)
              .findFirst();
      for (ComponentMutant defect : mutator.ofModule(source, modules.importers(file))) {
        mutants.add(
            new Mutant(name(run, file), file, source, defect, Mutant.Kind.MODULE, users, tested));
      }
    }
  }

  /** Returns the path of a module in the project: software bases refuse files elsewhere. */
  private static String name(RunContext run, Path file) {
    Path folder = run.project().folder().toAbsolutePath().normalize();
    return folder.relativize(file.toAbsolutePath().normalize()).toString().replace('\\', '/');
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
          boolean isBoolean = first.get().getType().equals("bool");
          pairs.add(new ComponentMutator.Pair(names.get(i), names.get(k), isBoolean));
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
        && ComponentUnits.of(one).equals(ComponentUnits.of(other));
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
