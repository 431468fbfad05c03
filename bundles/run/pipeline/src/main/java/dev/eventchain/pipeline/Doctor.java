package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.llm.service.ModelServices;
import dev.eventchain.llm.service.ServiceProbe;
import dev.eventchain.messages.RosDistribution;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.project.ProjectSettings;
import dev.eventchain.sandbox.PythonEnvironment;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** Checks this machine for the prerequisites of runs. */
public final class Doctor {

  /**
   * A check of a prerequisite of runs.
   *
   * @param name the name of the prerequisite
   * @param fine true if it is available
   * @param needed true if the project's runs fail without it
   * @param words the finding or the hint
   */
  public record Check(String name, boolean fine, boolean needed, String words) {}

  private Doctor() {}

  /**
   * Checks this machine, in a few seconds, or a minute if Python packages have to be downloaded for
   * the check. Nothing is installed.
   *
   * @param project the project with the models to check; empty for all services that need no
   *     configuration
   * @param environment the value of an environment variable, null if it is not set
   * @param progress receives lines for people while Python is checked
   */
  public static List<Check> look(
      Optional<Project> project, UnaryOperator<String> environment, Consumer<String> progress) {
    List<Check> checks = new ArrayList<>();
    checks.add(new Check("Java", true, true, System.getProperty("java.runtime.version")));
    checks.add(python(progress));
    checks.add(cycloneDds(progress));
    checks.add(messages(project, environment));
    ModelServices services =
        project.map(each -> each.configuration().services()).orElseGet(ModelServices::usual);
    Set<String> wanted = new TreeSet<>();
    project.ifPresent(each -> each.configuration().services(wanted::add));
    boolean live = project.filter(each -> each.configuration().asksServices()).isPresent();
    Set<String> names = wanted.isEmpty() ? services.names() : wanted;
    for (ServiceProbe.State state : ServiceProbe.look(services, names, environment)) {
      boolean needed = live && wanted.contains(state.name());
      checks.add(new Check("service " + state.name(), state.isReady(), needed, words(state)));
    }
    return checks;
  }

  private static Check python(Consumer<String> progress) {
    try {
      return new Check("Python", true, true, PythonEnvironment.outlook(progress) + "; confined");
    } catch (DiagnosticException e) {
      return new Check("Python", false, true, words(e));
    }
  }

  /** Checks Cyclone DDS, which only {@code --driver dds} needs. */
  private static Check cycloneDds(Consumer<String> progress) {
    String name = "Cyclone DDS";
    try {
      String outlook = PythonEnvironment.outlookWithCycloneDds(progress);
      return new Check(name, true, false, "for simulations with --driver dds: Python " + outlook);
    } catch (DiagnosticException e) {
      return new Check(name, false, false, words(e));
    }
  }

  /** Says which release of ROS 2 defines the standard messages. */
  private static Check messages(Optional<Project> project, UnaryOperator<String> environment) {
    RosDistribution used = project.map(Project::distribution).orElse(RosDistribution.DEFAULT);
    String setting = "'" + ProjectSettings.DISTRIBUTION + "' in eventchain.yaml";
    String others = String.join(" or ", RosDistribution.ids());
    String there = environment.apply("ROS_DISTRO");
    boolean differs = there != null && !there.isEmpty() && !there.equals(used.id());
    return new Check(
        "ROS 2 messages",
        true,
        false,
        "those of %s (%s: %s)%s"
            .formatted(
                used, setting, others, differs ? "; ROS_DISTRO is '" + there + "' here" : ""));
  }

  private static String words(DiagnosticException problem) {
    Diagnostic first = problem.diagnostics().get(0);
    return first.message() + " " + first.hint();
  }

  private static String words(ServiceProbe.State state) {
    String place = state.url() + state.problem().map(why -> ": " + why).orElse(" answers");
    return state
        .key()
        .map(key -> place + "; key " + key + (state.keyIsSet() ? " is set" : " is not set"))
        .orElse(place);
  }
}
