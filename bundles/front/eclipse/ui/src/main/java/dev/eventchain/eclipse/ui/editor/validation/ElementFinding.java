package dev.eventchain.eclipse.ui.editor.validation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * A finding about an element of a chain.
 *
 * @param element the element, or the chain itself
 * @param feature the feature; null if the finding concerns no particular one
 */
public record ElementFinding(Diagnostic finding, EObject element, EStructuralFeature feature) {

  public Severity severity() {
    return finding.severity();
  }

  /** Returns the message and the hint. */
  public String text() {
    String place = finding.location().file().isEmpty() ? "" : finding.location() + ": ";
    String hint = finding.hint().isEmpty() ? "" : " " + finding.hint();
    return place + finding.message() + hint;
  }

  /** Returns the same finding about the original of a copied element. */
  ElementFinding about(EObject original) {
    return new ElementFinding(finding, original, feature);
  }
}
