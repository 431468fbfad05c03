package dev.eventchain.maven;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.pipeline.ReportFile;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.apache.maven.model.Plugin;
import org.apache.maven.model.PluginExecution;
import org.apache.maven.plugin.MojoExecution;
import org.apache.maven.project.MavenProject;

/** Names of the reports of goals, and the reports that an earlier build has left. */
final class EarlierReports {

  /**
   * A goal on Maven's command line: {@code eventchain:validate@id}, with the plugin in any form.
   */
  private static final Pattern CALLED = Pattern.compile("(.+):([a-z]+)(?:@(.+))?");

  private EarlierReports() {}

  /** Returns the name of a goal's reports: with the execution's id unless it is the default. */
  static String name(String goal, String id) {
    return id.matches("default(-.*)?") ? goal : goal + "-" + id;
  }

  static Path sarif(Path folder, String name) {
    return folder.resolve(name + ".sarif");
  }

  static Path junit(Path folder, String name) {
    return folder.resolve("TEST-" + name + ".xml");
  }

  /**
   * Returns the names of the reports of a build: those of the goals on the command line and, if a
   * phase is among them, of all executions in the pom, whether they are reached or not.
   *
   * @param execution the current one
   * @param called goals and phases on the command line
   */
  static Set<String> names(MavenProject project, MojoExecution execution, List<String> called) {
    Set<String> names = new TreeSet<>();
    names.add(name(execution.getGoal(), execution.getExecutionId()));
    for (String word : called) {
      Matcher goal = CALLED.matcher(word);
      if (!goal.matches()) {
        names.addAll(inPom(project, execution.getPlugin().getKey()));
      } else if (goal.group(1).contains("eventchain")) {
        names.add(name(goal.group(2), Optional.ofNullable(goal.group(3)).orElse("default")));
      }
    }
    return names;
  }

  private static List<String> inPom(MavenProject project, String key) {
    Plugin plugin = project.getBuild().getPluginsAsMap().get(key);
    return plugin == null
        ? List.of()
        : plugin.getExecutions().stream().flatMap(EarlierReports::names).toList();
  }

  private static Stream<String> names(PluginExecution execution) {
    return execution.getGoals().stream().map(goal -> name(goal, execution.getId()));
  }

  /** Removes reports; returns a finding for each that cannot be removed. */
  static List<Diagnostic> remove(Path folder, Collection<String> names) {
    return names.stream()
        .flatMap(name -> Stream.of(sarif(folder, name), junit(folder, name)))
        .flatMap(file -> ReportFile.remove(file).stream())
        .toList();
  }
}
