package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.ComponentSignature;
import dev.eventchain.sandbox.SourceCheck;
import dev.eventchain.sandbox.SourceCheck.Source;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedSet;

/**
 * The source of existing components, of nodes that are hosted as they are, and of the modules that
 * they import, which is checked before anything is simulated. None of the code is run.
 */
public final class ComponentSources {

  private final RunContext run;
  private final List<Source> sources;
  private final List<Diagnostic> found;

  private ComponentSources(RunContext run, List<Source> sources, List<Diagnostic> found) {
    this.run = run;
    this.sources = sources;
    this.found = found;
  }

  /**
   * Reads the existing components of a chain, and the modules that they import.
   *
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static ComponentSources of(RunContext run) {
    EventChain chain = run.chain().chain();
    List<Source> sources = new ArrayList<>();
    for (SoftwareNode node : chain.getSoftware()) {
      run.softwareBase()
          .find(String.valueOf(node.getName()))
          .filter(ComponentSources::isClass)
          .ifPresent(it -> sources.add(source(it, Optional.of(signature(node)))));
    }
    addNodes(inChain(run, chain), sources);
    return withHelpers(run, existing(run, chain), sources);
  }

  /**
   * Reads all existing components where the chain is not known or has errors, so that what their
   * nodes need is not known.
   *
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static ComponentSources withoutChain(RunContext run) {
    List<SoftwareBase.Component> all =
        run.softwareBase().components().stream().filter(ComponentSources::isClass).toList();
    List<Source> sources = new ArrayList<>();
    all.forEach(it -> sources.add(source(it, Optional.empty())));
    addNodes(run.softwareBase().components(), sources);
    return withHelpers(run, all, sources);
  }

  private static ComponentSources withHelpers(
      RunContext run, Collection<SoftwareBase.Component> components, List<Source> described) {
    HelperModules helpers = HelperModules.of(components);
    List<Source> sources = new ArrayList<>(described);
    helpers.files().values().stream()
        .filter(file -> components.stream().noneMatch(each -> each.file().equals(file)))
        .forEach(file -> sources.add(Source.of(SourceText.read(file), Optional.empty())));
    return new ComponentSources(run, sources, helpers.diagnostics());
  }

  /** Returns the modules that the existing components of a chain import. */
  public static HelperModules helpers(RunContext run, EventChain chain) {
    return HelperModules.of(existing(run, chain));
  }

  /**
   * Returns the modules that components and nodes as they are import, without files of these.
   *
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static SortedSet<Path> modules(Collection<SoftwareBase.Component> components) {
    SortedSet<Path> modules = NodeModules.of(components);
    List<SoftwareBase.Component> classes =
        components.stream().filter(ComponentSources::isClass).toList();
    modules.addAll(HelperModules.of(classes).files().values());
    components.forEach(component -> modules.remove(component.file()));
    return modules;
  }

  /** Adds the files of nodes that are hosted as they are, and the modules that they import. */
  private static void addNodes(List<SoftwareBase.Component> components, List<Source> sources) {
    for (SoftwareBase.Component component : components) {
      component
          .node()
          .map(
              node ->
                  Source.ofNode(
                      SourceText.read(component.file()), node.className(), node.arguments()))
          .ifPresent(sources::add);
    }
    NodeModules.of(components)
        .forEach(file -> sources.add(Source.besideNode(SourceText.read(file))));
  }

  private static List<SoftwareBase.Component> existing(RunContext run, EventChain chain) {
    return inChain(run, chain).stream().filter(ComponentSources::isClass).toList();
  }

  private static List<SoftwareBase.Component> inChain(RunContext run, EventChain chain) {
    return chain.getSoftware().stream()
        .flatMap(node -> run.softwareBase().find(String.valueOf(node.getName())).stream())
        .distinct()
        .toList();
  }

  private static boolean isClass(SoftwareBase.Component component) {
    return component.implementation() == ComponentImplementation.COMPONENT;
  }

  /**
   * Checks each component against what its node needs, and all files for what makes results differ
   * from run to run.
   *
   * @param stage the stage that checks them
   * @return the findings; a warning if there is no Python, so that nothing was checked
   * @throws DiagnosticException INPUT if the settings of Python are wrong
   */
  public List<Diagnostic> check(Stage stage) {
    List<Diagnostic> all = new ArrayList<>(found);
    if (sources.isEmpty()) {
      return all;
    }
    try {
      all.addAll(new SourceCheck(run.python(stage)).check(sources));
    } catch (DiagnosticException e) {
      if (e.reason() != DiagnosticException.Reason.UNAVAILABLE) {
        throw e;
      }
      all.add(unchecked(sources.size(), e.diagnostics().get(0)));
    }
    return all;
  }

  private static Diagnostic unchecked(int count, Diagnostic reason) {
    return Diagnostic.of(
            StageRules.COMPONENT_SOURCE_UNCHECKED,
            "The source of %s was not looked into: %s"
                .formatted(Coverage.counted(count, "Python file"), reason.message()),
            SourceLocation.NONE)
        .withHint(reason.hint());
  }

  private static Source source(
      SoftwareBase.Component component, Optional<ComponentSignature> signature) {
    return Source.of(SourceText.read(component.file()), signature);
  }

  private static ComponentSignature signature(SoftwareNode node) {
    return new ComponentSignature(node.getName(), names(node.getInput()), names(node.getOutput()));
  }

  private static List<String> names(Collection<Data> values) {
    return values.stream().map(Data::getName).filter(Objects::nonNull).distinct().toList();
  }
}
