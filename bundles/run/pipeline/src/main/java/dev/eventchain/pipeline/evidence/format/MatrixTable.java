package dev.eventchain.pipeline.evidence.format;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.CsvText;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.Component;
import dev.eventchain.pipeline.evidence.Evidence.Requirement;
import dev.eventchain.pipeline.evidence.Evidence.Result;
import dev.eventchain.pipeline.evidence.Evidence.Strength;
import dev.eventchain.pipeline.evidence.Evidence.Test;
import java.util.List;
import java.util.OptionalLong;
import java.util.stream.Collectors;

/**
 * A table with a row for each requirement and each test or scenario that judges it. A requirement
 * without any has one row, in which these columns are empty.
 */
final class MatrixTable {

  private static final List<String> COLUMNS =
      List.of(
          "requirement",
          "text",
          "verdict",
          "faults_noticed",
          "faults_driven",
          "faults_sampled_of",
          "components",
          "kind",
          "name",
          "result",
          "linked",
          "file",
          "line",
          "reason");

  private final Evidence evidence;
  private final CsvText table = new CsvText("\n");

  private MatrixTable(Evidence evidence) {
    this.evidence = evidence;
  }

  static byte[] render(Evidence evidence) {
    MatrixTable matrix = new MatrixTable(evidence);
    matrix.table.row(COLUMNS);
    evidence.requirements().forEach(matrix::rows);
    return matrix.table.bytes();
  }

  private void rows(Requirement requirement) {
    List<Test> tests =
        evidence.tests().stream().filter(each -> each.about(requirement.id()).isPresent()).toList();
    if (tests.isEmpty()) {
      row(requirement, "", "", "", "", SourceLocation.NONE);
    }
    for (Test test : tests) {
      Result result = test.about(requirement.id()).orElseThrow();
      row(
          requirement,
          test.component().isPresent() ? "component test" : "scenario",
          test.fullName(),
          result.words(),
          evidence.supportedBy(test).contains(requirement.id()) ? "yes" : "no",
          test.place());
    }
  }

  private void row(
      Requirement requirement,
      String kind,
      String name,
      String result,
      String linked,
      SourceLocation place) {
    table.row(
        List.of(
            requirement.id(),
            requirement.text(),
            requirement.verdict().words(),
            requirement.strength().map(it -> Integer.toString(it.noticed())).orElse(""),
            requirement.strength().map(it -> Integer.toString(it.faults())).orElse(""),
            sampled(requirement.strength().map(Strength::sampleOf).orElse(OptionalLong.empty())),
            evidence.componentsOf(requirement.id()).stream()
                .map(Component::name)
                .collect(Collectors.joining(" ")),
            kind,
            name,
            result,
            linked,
            place.file(),
            place.line() > 0 ? Integer.toString(place.line()) : "",
            requirement.reason().orElse("")));
  }

  private static String sampled(OptionalLong faults) {
    return faults.isPresent() ? Long.toString(faults.getAsLong()) : "";
  }
}
