package dev.eventchain.maven;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.apache.maven.model.InputLocation;
import org.apache.maven.model.Plugin;
import org.apache.maven.model.PluginExecution;
import org.apache.maven.plugin.MojoExecution;
import org.apache.maven.plugin.descriptor.MojoDescriptor;
import org.apache.maven.project.MavenProject;
import org.codehaus.plexus.util.xml.Xpp3Dom;

/**
 * Checks the pom for configuration that Maven ignores silently: parameters that no goal has, and
 * elements without a value. A misspelt {@code <constraints>} would otherwise pass every model.
 */
final class PomParameters {

  private final Set<String> known = new TreeSet<>();
  private final List<Diagnostic> found = new ArrayList<>();

  private PomParameters(MojoExecution execution) {
    for (MojoDescriptor goal : execution.getMojoDescriptor().getPluginDescriptor().getMojos()) {
      goal.getParameters().stream()
          .filter(parameter -> parameter.isEditable())
          .flatMap(parameter -> Stream.of(parameter.getName(), parameter.getAlias()))
          .filter(Objects::nonNull)
          .forEach(known::add);
    }
  }

  /** Returns the problems in the configuration of an execution; empty if the pom has none. */
  static List<Diagnostic> check(MavenProject project, MojoExecution execution) {
    String key = execution.getPlugin().getKey();
    Plugin plugin = project.getPlugin(key);
    if (plugin == null && project.getPluginManagement() != null) {
      // A goal that is called by name takes its configuration from there.
      plugin = project.getPluginManagement().getPluginsAsMap().get(key);
    }
    if (plugin == null) {
      return List.of();
    }
    PomParameters parameters = new PomParameters(execution);
    PluginExecution own = plugin.getExecutionsAsMap().get(execution.getExecutionId());
    // Maven has merged the plugin's configuration into that of its executions.
    Object configuration = own == null ? plugin.getConfiguration() : own.getConfiguration();
    if (configuration instanceof Xpp3Dom all) {
      parameters.check(all);
    }
    return parameters.found;
  }

  private void check(Xpp3Dom configuration) {
    for (Xpp3Dom parameter : configuration.getChildren()) {
      if (known.contains(parameter.getName())) {
        isFilled(parameter);
      } else {
        report(
            parameter,
            "The plugin has no parameter <" + parameter.getName() + ">.",
            NearestName.hint(parameter.getName(), known));
      }
    }
  }

  private void isFilled(Xpp3Dom element) {
    for (Xpp3Dom child : element.getChildren()) {
      isFilled(child);
    }
    boolean isEmpty =
        element.getChildCount() == 0
            && (element.getValue() == null || element.getValue().isBlank());
    if (isEmpty && element.getAttribute(Xpp3Dom.SELF_COMBINATION_MODE_ATTRIBUTE) == null) {
      report(
          element,
          "The element <" + element.getName() + "> has no value.",
          "Give it one, or leave it out.");
    }
  }

  private void report(Xpp3Dom element, String message, String hint) {
    found.add(Diagnostic.of(GoalRules.PARAMETER, message, place(element)).withHint(hint));
  }

  private static SourceLocation place(Xpp3Dom element) {
    if (element.getInputLocation() instanceof InputLocation at
        && at.getSource() != null
        && at.getSource().getLocation() != null) {
      Path pom = Places.shown(new File(at.getSource().getLocation()));
      return new SourceLocation("", at.getLineNumber(), at.getColumnNumber(), "", "").inFile(pom);
    }
    return SourceLocation.NONE;
  }
}
