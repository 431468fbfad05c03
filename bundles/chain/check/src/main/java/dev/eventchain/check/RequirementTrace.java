package dev.eventchain.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.Requirement;
import java.util.ArrayList;
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
    Map<String, String> texts =
        written.stream()
            .collect(
                Collectors.toMap(WrittenRequirement::id, WrittenRequirement::text, (a, b) -> a));
    List<Diagnostic> found = new ArrayList<>();
    if (written.isEmpty()) {
      return found;
    }
    for (Requirement requirement : chain.getRequirements()) {
      String text = texts.get(requirement.getId());
      if (text == null) {
        found.add(unknown(requirement, texts, locator));
      } else if (!plain(text).equals(plain(requirement.getText()))) {
        found.add(changed(requirement, text, locator));
      }
    }
    return found;
  }

  private static Diagnostic unknown(
      Requirement requirement,
      Map<String, String> texts,
      BiFunction<EObject, EStructuralFeature, SourceLocation> locator) {
    String id = String.valueOf(requirement.getId());
    return Diagnostic.of(
            CheckRules.PROJECT_REQUIREMENT_UNKNOWN,
            "The model has the requirement '" + id + "', which requirements.md does not have.",
            locator.apply(requirement, Literals.REQUIREMENT__ID))
        .withHint(NearestName.question(id, texts.keySet()));
  }

  private static Diagnostic changed(
      Requirement requirement,
      String text,
      BiFunction<EObject, EStructuralFeature, SourceLocation> locator) {
    return Diagnostic.of(
            CheckRules.PROJECT_REQUIREMENT_CHANGED,
            "requirements.md says this about %s: %s".formatted(requirement.getId(), text),
            locator.apply(requirement, Literals.REQUIREMENT__TEXT))
        .withHint("Write the same into the model, once the components satisfy it.");
  }

  private static String plain(String text) {
    return text == null ? "" : text.strip().replaceAll("\\s+", " ");
  }
}
