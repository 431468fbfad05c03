package dev.eventchain.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.Requirement;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Comparison of the requirements of a model with those written in the project. An edited model has
 * copies of them, which can become outdated.
 */
final class RequirementTrace {

  private RequirementTrace() {}

  /**
   * Compares ids and texts; nothing is compared if the project has written no requirements.
   *
   * @return {@code project.requirement.unknown}, {@code project.requirement.changed}
   */
  static List<Diagnostic> check(
      List<WrittenRequirement> written,
      EventChain chain,
      BiFunction<EObject, EStructuralFeature, SourceLocation> locator) {
    Map<String, WrittenRequirement> byId =
        written.stream().collect(Collectors.toMap(WrittenRequirement::id, it -> it, (a, b) -> a));
    List<Diagnostic> found = new ArrayList<>();
    if (written.isEmpty()) {
      return found;
    }
    for (Requirement requirement : chain.getRequirements()) {
      WrittenRequirement item = byId.get(requirement.getId());
      if (item == null) {
        found.add(unknown(requirement, byId, locator));
      } else if (!plain(item.text()).equals(plain(requirement.getText()))) {
        found.add(changed(requirement, item, locator));
      }
    }
    return found;
  }

  private static Diagnostic unknown(
      Requirement requirement,
      Map<String, WrittenRequirement> written,
      BiFunction<EObject, EStructuralFeature, SourceLocation> locator) {
    String id = String.valueOf(requirement.getId());
    return Diagnostic.of(
            CheckRules.PROJECT_REQUIREMENT_UNKNOWN,
            "The model has the requirement '%s', which %s not have."
                .formatted(id, files(written.values())),
            locator.apply(requirement, Literals.REQUIREMENT__ID))
        .withHint(NearestName.question(id, written.keySet()));
  }

  private static Diagnostic changed(
      Requirement requirement,
      WrittenRequirement item,
      BiFunction<EObject, EStructuralFeature, SourceLocation> locator) {
    return Diagnostic.of(
            CheckRules.PROJECT_REQUIREMENT_CHANGED,
            "%s says this about %s: %s".formatted(name(item), requirement.getId(), item.text()),
            locator.apply(requirement, Literals.REQUIREMENT__TEXT))
        .withHint("Write the same into the model, once the components satisfy it.");
  }

  private static String name(WrittenRequirement item) {
    String file = item.location().file();
    return file.substring(file.lastIndexOf('/') + 1);
  }

  /** Returns the files of requirements as a subject: "requirements.md does". */
  private static String files(Collection<WrittenRequirement> written) {
    List<String> files = written.stream().map(RequirementTrace::name).distinct().sorted().toList();
    return files.size() == 1 ? files.get(0) + " does" : "the files of requirements do";
  }

  private static String plain(String text) {
    return text == null ? "" : text.strip().replaceAll("\\s+", " ");
  }
}
