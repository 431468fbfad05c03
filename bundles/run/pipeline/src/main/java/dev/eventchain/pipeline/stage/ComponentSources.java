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
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Checks of the source of existing components and of the modules that they import, before anything
 * is simulated. None of their code is run.
 */
public final class ComponentSources {

  private ComponentSources() {}

  /**
   * Checks the existing components of a chain: each against what its node needs, and all for what
   * makes results differ from run to run.
   *
   * @param stage the stage that checks them
   * @return the findings; a warning if there is no Python, so that nothing was checked
   * @throws DiagnosticException INPUT if a file cannot be read
   */
  public static List<Diagnostic> check(RunContext run, Stage stage) {
    EventChain chain = run.chain().chain();
    List<Source> sources = new ArrayList<>();
    for (SoftwareNode node : chain.getSoftware()) {
      run.softwareBase()
          .find(String.valueOf(node.getName()))
          .filter(ComponentSources::isClass)
          .ifPresent(it -> sources.add(source(it, Optional.of(signature(node)))));
    }
    return check(run, existing(run, chain), sources, stage);
  }

  /**
   * Checks all existing components where the chain is not known or has errors, so that what their
   * nodes need is not known.
   *
   * @throws DiagnosticException as {@link #check}
   */
  public static List<Diagnostic> checkWithoutChain(RunContext run, Stage stage) {
    List<SoftwareBase.Component> all =
        run.softwareBase().components().stream().filter(ComponentSources::isClass).toList();
    List<Source> sources = all.stream().map(each -> source(each, Optional.empty())).toList();
    return check(run, all, sources, stage);
  }

  /** Returns the modules that the existing components of a chain import. */
  public static HelperModules helpers(RunContext run, EventChain chain) {
    return HelperModules.of(existing(run, chain));
  }

  private static List<SoftwareBase.Component> existing(RunContext run, EventChain chain) {
    return chain.getSoftware().stream()
        .flatMap(node -> run.softwareBase().find(String.valueOf(node.getName())).stream())
        .filter(ComponentSources::isClass)
        .distinct()
        .toList();
  }

  private static boolean isClass(SoftwareBase.Component component) {
    return component.implementation() == ComponentImplementation.COMPONENT;
  }

  private static List<Diagnostic> check(
      RunContext run,
      Collection<SoftwareBase.Component> components,
      List<Source> described,
      Stage stage) {
    HelperModules helpers = HelperModules.of(components);
    List<Source> sources = new ArrayList<>(described);
    helpers.files().values().stream()
        .filter(file -> components.stream().noneMatch(each -> each.file().equals(file)))
        .forEach(file -> sources.add(new Source(SourceText.read(file), Optional.empty())));
    List<Diagnostic> found = new ArrayList<>(helpers.diagnostics());
    if (!sources.isEmpty()) {
      found.addAll(check(run, sources, stage));
    }
    return found;
  }

  private static List<Diagnostic> check(RunContext run, List<Source> sources, Stage stage) {
    try {
      return new SourceCheck(run.python(stage)).check(sources);
    } catch (DiagnosticException e) {
      if (e.reason() != DiagnosticException.Reason.UNAVAILABLE) {
        throw e;
      }
      return List.of(unchecked(sources.size(), e.diagnostics().get(0)));
    }
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
    return new Source(SourceText.read(component.file()), signature);
  }

  private static ComponentSignature signature(SoftwareNode node) {
    return new ComponentSignature(node.getName(), names(node.getInput()), names(node.getOutput()));
  }

  private static List<String> names(Collection<Data> values) {
    return values.stream().map(Data::getName).filter(Objects::nonNull).distinct().toList();
  }
}
