package dev.eventchain.pipeline.campaign;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.documents.YamlLayout;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.campaign.plan.PlayedScenario;
import dev.eventchain.pipeline.campaign.plan.Purpose;
import dev.eventchain.simulation.scenario.VariedScenario;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Campaigns about files in OpenSCENARIO XML: a campaign file with their parameters as factors, and
 * a scenario with what is required, are written, and then read as any others are.
 */
public final class OpenScenarioCampaigns {

  /** The folder of what is written, in the output folder. */
  static final String FOLDER = "openscenario";

  private final VariedScenario varied;
  private final String name;

  private OpenScenarioCampaigns(Path file) {
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
   * @return the campaign file
   * @throws DiagnosticException with all problems of the file; if nothing in it varies, or nothing
   *     that numbers can say; if nothing is required
   */
  public static Path write(Path file, List<String> accept, Path output) {
    return write(file, accept, output, Purpose.CAMPAIGN);
  }

  /** As {@link #write}, for a search between the bounds of what varies. */
  public static Path writeForSearch(Path file, List<String> accept, Path output) {
    return write(file, accept, output, Purpose.SEARCH);
  }

  static Path write(Path file, List<String> accept, Path output, Purpose purpose) {
    OpenScenarioCampaigns campaigns = new OpenScenarioCampaigns(file);
    PlayedScenario.refusal(file, campaigns.varied, purpose)
        .ifPresent(
            finding -> {
              throw new DiagnosticException(DiagnosticException.Reason.INPUT, List.of(finding));
            });
    Path folder = output.toAbsolutePath().normalize().resolve(FOLDER);
    String played = ScenarioTemplate.path(folder, campaigns.varied.scenario());
    try (OutputFolder written = OutputFolder.open(folder)) {
      write(
          written,
          campaigns.scenarioFile(),
          YamlLayout.of(campaigns.varied.written(played, accept)));
      if (!campaigns.varied.rows().isEmpty()) {
        write(written, campaigns.table(), campaigns.rows());
      }
      write(written, campaigns.name + ".yaml", YamlLayout.of(campaigns.campaign(purpose)));
    }
    return folder.resolve(campaigns.name + ".yaml");
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

  private ObjectNode campaign(Purpose purpose) {
    ObjectNode campaign = JsonNodeFactory.instance.objectNode();
    campaign.put("scenario", scenarioFile());
    ObjectNode factors = campaign.putObject("factors");
    List<String> names = PlayedScenario.names(varied);
    for (int i = 0; i < names.size(); i++) {
      factor(factors.putObject(names.get(i)), varied.parameters().get(i));
    }
    boolean ranges = varied.parameters().stream().anyMatch(VariedScenario.Parameter::isRange);
    if (!varied.rows().isEmpty()) {
      campaign.putObject("sampling").put("rows", true);
    } else if (ranges && purpose == Purpose.CAMPAIGN) {
      campaign.putObject("sampling").put("halton", PlayedScenario.DRAWN);
    }
    return campaign;
  }

  private void factor(ObjectNode factor, VariedScenario.Parameter parameter) {
    factor.put("path", PlayedScenario.PATH + parameter.name());
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
