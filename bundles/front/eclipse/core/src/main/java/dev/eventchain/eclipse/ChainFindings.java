package dev.eventchain.eclipse;

import dev.eventchain.check.ChainChecks;
import dev.eventchain.constraints.document.ConstraintRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.xmi.Origins;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Findings about a chain in memory, with the elements concerned.
 *
 * @param found the findings, in the order of the checks
 * @param evaluations number of evaluations of constraints, contracts and rules of the metamodel; 0
 *     means that nothing was checked
 */
public record ChainFindings(List<Found> found, long evaluations) {

  /**
   * A finding and its element.
   *
   * @param element empty if the finding concerns the whole chain or another file
   * @param feature the feature of the element, if the finding concerns one
   * @param diagnostic the finding, whose location has the path of the element
   */
  public record Found(
      Optional<EObject> element, Optional<EStructuralFeature> feature, Diagnostic diagnostic) {}

  /** Returns the error about a chain that was not checked. */
  public static Diagnostic nothingChecked(String message) {
    return Diagnostic.of(ConstraintRules.NOTHING_EVALUATED, message, SourceLocation.NONE);
  }

  /** Locations of elements, since a chain in memory has neither file nor lines. */
  private static final class Places {
    private static final String MARK = "#";

    private final List<EObject> elements = new ArrayList<>();
    private final Map<EObject, Integer> numbers = new IdentityHashMap<>();
    private final Origins paths = new Origins();

    SourceLocation of(EObject element) {
      int number =
          numbers.computeIfAbsent(
              element,
              each -> {
                elements.add(each);
                return elements.size() - 1;
              });
      return SourceLocation.NONE.withElement(MARK + number);
    }

    SourceLocation of(EObject element, EStructuralFeature feature) {
      return SourceLocation.NONE.withElement(of(element).element() + MARK + feature.getFeatureID());
    }

    Found found(Diagnostic finding) {
      String[] mark = finding.location().element().split(MARK);
      if (!finding.location().element().startsWith(MARK)) {
        return new Found(Optional.empty(), Optional.empty(), finding);
      }
      EObject element = elements.get(Integer.parseInt(mark[1]));
      Optional<EStructuralFeature> feature =
          mark.length < 3
              ? Optional.empty()
              : Optional.of(element.eClass().getEStructuralFeature(Integer.parseInt(mark[2])));
      SourceLocation[] related =
          finding.related().stream().map(this::plain).toArray(SourceLocation[]::new);
      Diagnostic plain = finding.withLocation(plain(finding.location())).withRelated(related);
      return new Found(Optional.of(element), feature, plain);
    }

    private SourceLocation plain(SourceLocation place) {
      if (!place.element().startsWith(MARK)) {
        return place;
      }
      return paths.locate(elements.get(Integer.parseInt(place.element().split(MARK)[1])));
    }
  }

  /**
   * Checks a chain. It must not change meanwhile, so editors check a copy.
   *
   * @param checks the checks of the chain's project, or those for a chain outside projects
   */
  public static ChainFindings of(EventChain chain, ChainChecks checks) {
    Places places = new Places();
    ChainChecks.Outcome outcome = checks.check(chain, places::of, places::of);
    List<Found> found = outcome.diagnostics().stream().map(places::found).toList();
    return new ChainFindings(found, CheckSummary.evaluations(outcome.coverage(List.of())));
  }
}
