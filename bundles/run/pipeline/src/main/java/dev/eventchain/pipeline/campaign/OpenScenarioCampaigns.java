package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.YamlLayout;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.simulation.scenario.VariedScenario;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Campaigns about files in OpenSCENARIO XML: a campaign file with their parameters as factors, and
 * a scenario with what is required, are written, and then read as any others are.
 */
public final class OpenScenarioCampaigns {

  private static final String FOLDER = "openscenario";

  /** Cases of a scenario whose parameters have bounds only. */
  private static final int DRAWN = 100;

  private final Path file;
  private final VariedScenario varied;
  private final String name;

  private OpenScenarioCampaigns(Path file) {
    this.file = file;
    this.varied = VariedScenario.read(file);
    this.name = VariedScenario.nameOf(file);
  }

  /** Returns whether a file is one in OpenSCENARIO XML, by its name. */
  public static boolean isOne(Path file) {
    return VariedScenario.isOne(file);
  }

  /**
   * Writes a campaign about a scenario, or about the cases of a file of distributions.
   *
   * @param accept what is required: {@code KEY} or {@code KEY=NUMBER} each
   * @param output the folder of results
   * @param isSearched whether a search goes between the bounds of what varies
   * @return the campaign file
   * @throws DiagnosticException with all problems of the file; if nothing in it varies, or nothing
   *     that numbers can say; if nothing is required
   */
  public static Path write(Path file, List<String> accept, Path output, boolean isSearched) {
    OpenScenarioCampaigns campaigns = new OpenScenarioCampaigns(file);
    campaigns.requireNumbers(isSearched);
    Path folder = output.toAbsolutePath().normalize().resolve(FOLDER);
    Path scenario = campaigns.varied.scenario().toAbsolutePath().normalize();
    ObjectNode played = campaigns.varied.written(path(folder, scenario), accept);
    try (OutputFolder written = OutputFolder.open(folder)) {
      write(written, campaigns.scenarioFile(), YamlLayout.of(played));
      if (!campaigns.varied.rows().isEmpty()) {
        write(written, campaigns.table(), campaigns.rows());
      }
      write(written, campaigns.name + ".yaml", YamlLayout.of(campaigns.campaign(isSearched)));
    }
    return folder.resolve(campaigns.name + ".yaml");
  }

  /** Returns a path from a folder, so that results do not depend on where a project lies. */
  private static String path(Path folder, Path file) {
    boolean related = folder.getRoot().equals(file.getRoot());
    return (related ? folder.relativize(file) : file).toString().replace('\\', '/');
  }

  private static void write(OutputFolder written, String name, String text) {
    written
        .write(name, text.getBytes(StandardCharsets.UTF_8), OutputFolder.OnEdit.OVERWRITE)
        .finding()
        .filter(finding -> Diagnostic.anyError(List.of(finding)))
        .ifPresent(
            finding -> {
              throw new DiagnosticException(DiagnosticException.Reason.INPUT, List.of(finding));
            });
  }

  private String scenarioFile() {
    return name + "-scenario.yaml";
  }

  private String table() {
    return name + ".csv";
  }

  private void requireNumbers(boolean isSearched) {
    if (varied.parameters().isEmpty()) {
      throw refused(
          CampaignRules.EMPTY,
          "Nothing varies in this file: no number among its parameters has a lower and an upper"
              + " limit, or two values.",
          "Give a parameter a ConstraintGroup with both limits, name a file of parameter value"
              + " distributions, or write a campaign file with the parameter as a factor.");
    }
    for (VariedScenario.Parameter each : varied.parameters()) {
      if (!each.isNumeric()) {
        throw refused(
            CampaignRules.FACTOR,
            "'" + each.name() + "' differs between the cases, and its values are no numbers.",
            "Simulate the file: `eventchain simulate DIR --scenario-file "
                + file.getFileName()
                + " --accept ...`.");
      }
    }
    if (isSearched && !varied.rows().isEmpty()) {
      throw refused(
          CampaignRules.FACTOR,
          "The cases of this file are not all combinations of their values, between which a search"
              + " could go.",
          "Use `campaign`, or write a campaign file with the bounds of each parameter.");
    }
  }

  private DiagnosticException refused(Rule rule, String message, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(rule, message, SourceLocation.of(file)).withHint(hint));
  }

  private ObjectNode campaign(boolean isSearched) {
    ObjectNode campaign = JsonNodeFactory.instance.objectNode();
    campaign.put("scenario", scenarioFile());
    ObjectNode factors = campaign.putObject("factors");
    Set<String> names = new HashSet<>();
    for (VariedScenario.Parameter each : varied.parameters()) {
      String factor = each.name().replaceAll("[^A-Za-z0-9_]", "_").replaceFirst("^(?=\\d)", "_");
      while (!names.add(factor)) {
        factor += "_";
      }
      factor(factors.putObject(factor), each);
    }
    boolean ranges = varied.parameters().stream().anyMatch(VariedScenario.Parameter::isRange);
    if (!varied.rows().isEmpty()) {
      campaign.putObject("sampling").put("rows", true);
    } else if (ranges && !isSearched) {
      campaign.putObject("sampling").put("halton", DRAWN);
    }
    return campaign;
  }

  private void factor(ObjectNode factor, VariedScenario.Parameter parameter) {
    factor.put("path", "openscenario.parameters." + parameter.name());
    if (!varied.rows().isEmpty()) {
      factor.put("csv", table()).put("column", parameter.name());
      return;
    }
    ArrayNode values = factor.putArray(parameter.isRange() ? "uniform" : "values");
    parameter.numbers().forEach(values::add);
  }

  private String rows() {
    List<String> lines = new ArrayList<>();
    lines.add(
        varied.parameters().stream()
            .map(VariedScenario.Parameter::name)
            .collect(Collectors.joining(",")));
    varied.rows().forEach(row -> lines.add(String.join(",", row)));
    return String.join("\n", lines) + "\n";
  }
}
