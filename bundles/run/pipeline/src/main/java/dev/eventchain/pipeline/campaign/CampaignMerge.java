package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;

/** Puts the parts of a campaign together. */
final class CampaignMerge {

  private final TreeMap<Integer, CampaignStore.Cases> parts = new TreeMap<>();
  private final List<Diagnostic> problems = new ArrayList<>();

  /**
   * Returns the cases of all parts.
   *
   * @param folders the folders of the parts, in any order
   * @throws DiagnosticException (INPUT) {@code campaign.merge} if one is missing, twice, broken or
   *     of other inputs
   */
  static List<CampaignRow> rows(List<Path> folders, String inputs) {
    CampaignMerge merge = new CampaignMerge();
    folders.forEach(folder -> merge.add(folder, inputs));
    merge.requireAll(folders);
    if (!merge.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, merge.problems);
    }
    return merge.parts.values().stream()
        .flatMap(part -> part.rows().stream())
        .sorted(CampaignRow.ORDER)
        .toList();
  }

  private void add(Path folder, String inputs) {
    Path file = folder.resolve(CampaignStore.CASES);
    CampaignStore.Cases cases;
    try {
      cases = CampaignStore.read(Files.readAllBytes(file)).orElse(null);
    } catch (IOException e) {
      problem(folder, "has no " + CampaignStore.CASES + ", so that this part is not complete", "");
      return;
    }
    if (cases == null || !cases.complete()) {
      problem(folder, "is broken, or from another version of this program", "");
    } else if (!cases.inputs().equals(inputs)) {
      problem(
          folder,
          "is of another state of the project, the campaign file or this program",
          "Simulate this part again with what is here now.");
    } else if (parts.putIfAbsent(cases.shard().number(), cases) != null) {
      problem(folder, "is part " + cases.shard().number() + ", which another one is, too", "");
    }
  }

  private void requireAll(List<Path> folders) {
    if (parts.isEmpty() || !problems.isEmpty()) {
      return;
    }
    int count = parts.firstEntry().getValue().shard().count();
    for (int number = 1; number <= count; number++) {
      CampaignStore.Cases part = parts.get(number);
      if (part == null || part.shard().count() != count) {
        problem(folders.get(0), "and the others lack part %d of %d".formatted(number, count), "");
      }
    }
  }

  private void problem(Path folder, String what, String hint) {
    problems.add(
        Diagnostic.of(CampaignRules.MERGE, folder + " " + what + ".", SourceLocation.of(folder))
            .withHint(hint));
  }
}
