package dev.eventchain.eclipse.ui.editor.validation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * A finding about an element of a chain.
 *
 * @param element the chain if it is about nothing else in it
 * @param feature null if it is about none in particular
 */
public record ElementFinding(Diagnostic finding, EObject element, EStructuralFeature feature) {

  public Severity severity() {
    return finding.severity();
  }

  /** What is wrong, and what to do about it. */
  public String text() {
    String place = finding.location().file().isEmpty() ? "" : finding.location() + ": ";
    String hint = finding.hint().isEmpty() ? "" : " " + finding.hint();
    return place + finding.message() + hint;
  }

  /** The same finding about the element that another one is a copy of. */
  ElementFinding about(EObject original) {
    return new ElementFinding(finding, original, feature);
  }
}
