package dev.eventchain.pipeline.campaign.result;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.campaign.plan.CampaignRules;
import dev.eventchain.pipeline.campaign.plan.Shard;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.TreeMap;

/** Puts the parts of a campaign together. */
public final class CampaignMerge {

  private final TreeMap<Integer, CampaignStore.Cases> parts = new TreeMap<>();
  private final List<Diagnostic> problems = new ArrayList<>();

  /**
   * Returns all parts, in their order.
   *
   * @param folders the folders of the parts, in any order
   * @throws DiagnosticException (INPUT) {@code campaign.merge} if one is missing, twice, broken, of
   *     other inputs, or of another platform than the first one
   */
  public static List<CampaignStore.Cases> parts(List<Path> folders, String inputs) {
    CampaignMerge merge = new CampaignMerge();
    folders.forEach(folder -> merge.add(folder, inputs));
    merge.requireAll(folders);
    if (!merge.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, merge.problems);
    }
    return List.copyOf(merge.parts.values());
  }

  /**
   * Returns a part that was simulated elsewhere.
   *
   * @param own cases that it has to fit to
   * @param node where it was simulated
   * @throws DiagnosticException (INPUT) {@code campaign.merge} if it does not
   */
  public static CampaignStore.Cases require(
      byte[] bytes, CampaignStore.Cases own, Shard shard, String node) {
    CampaignStore.Cases part = CampaignStore.read(bytes).orElse(null);
    Path name = Path.of(shard.folder(own.campaign()));
    CampaignMerge merge = new CampaignMerge();
    if (merge.isSound(name, part, own.inputs()) && !part.shard().equals(shard)) {
      merge.problem(name, "is another part", "");
    } else if (merge.problems.isEmpty() && !part.isLike(own)) {
      merge.problem(
          name,
          "was simulated with %s on the node %s, but this machine has %s"
              .formatted(part.platform(), node, own.platform()),
          "Let all nodes have the same: one image, EVENTCHAIN_PYTHON, JAVA_HOME, bubblewrap.");
    }
    if (!merge.problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, merge.problems);
    }
    return part;
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
    if (!isSound(folder, cases, inputs)) {
      return;
    }
    CampaignStore.Cases first = parts.isEmpty() ? cases : parts.firstEntry().getValue();
    String platform = first.platform();
    if (cases.shard().count() != first.shard().count()) {
      problem(
          folder,
          "is one of %s parts, but another one is one of %s"
              .formatted(cases.shard().count(), first.shard().count()),
          "Put the parts of one division together.");
    } else if (parts.putIfAbsent(cases.shard().number(), cases) != null) {
      problem(folder, "is part " + cases.shard().number() + ", which another one is, too", "");
    } else if (!cases.platform().equals(platform)) {
      problem(
          folder,
          "was simulated with " + cases.platform() + ", but another one with " + platform,
          "Simulate all parts with the same Python, Java and confinement.");
    }
  }

  private boolean isSound(Path folder, CampaignStore.Cases cases, String inputs) {
    if (cases == null || !cases.complete()) {
      problem(folder, "is broken, or from another version of this program", "");
      return false;
    }
    if (!cases.inputs().equals(inputs)) {
      problem(
          folder,
          "is of another state of the project, the campaign file or this program",
          "Simulate this part again with what is here now.");
      return false;
    }
    return true;
  }

  private void requireAll(List<Path> folders) {
    if (parts.isEmpty() || !problems.isEmpty()) {
      return;
    }
    int count = parts.firstEntry().getValue().shard().count();
    for (int number = 1; number <= count; number++) {
      if (!parts.containsKey(number)) {
        problem(
            folders.get(0),
            String.format(Locale.ROOT, "and the others lack part %d of %d", number, count),
            "");
      }
    }
  }

  private void problem(Path folder, String what, String hint) {
    problems.add(
        Diagnostic.of(CampaignRules.MERGE, folder + " " + what + ".", SourceLocation.of(folder))
            .withHint(hint));
  }
}
