package dev.eventchain.eclipse.ui.editor.field;

import dev.eventchain.eclipse.ui.editor.model.Completions;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.jface.bindings.keys.KeyStroke;
import org.eclipse.jface.fieldassist.ComboContentAdapter;
import org.eclipse.jface.fieldassist.ContentProposal;
import org.eclipse.jface.fieldassist.ContentProposalAdapter;
import org.eclipse.jface.fieldassist.ControlDecoration;
import org.eclipse.jface.fieldassist.FieldDecorationRegistry;
import org.eclipse.jface.fieldassist.IContentProposal;
import org.eclipse.jface.fieldassist.IControlContentAdapter;
import org.eclipse.jface.fieldassist.TextContentAdapter;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Combo;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;

/** Content assist for the fields of the editor: Ctrl+Space, with a light bulb as hint. */
final class Proposals {

  /** Largest number of proposals; typing more shortens the list. */
  private static final int MOST = 200;

  private Proposals() {}

  /** Offers proposals for a text field, if there are any. */
  static void offer(
      Completions completions, Text text, EObject element, EStructuralFeature feature) {
    if (completions.knows(feature)) {
      attach(completions, text, new TextContentAdapter(), element, feature);
    }
  }

  /** Offers proposals for an editable list. */
  static void offer(
      Completions completions, Combo combo, EObject element, EStructuralFeature feature) {
    attach(completions, combo, new ComboContentAdapter(), element, feature);
  }

  private static void attach(
      Completions completions,
      Control control,
      IControlContentAdapter adapter,
      EObject element,
      EStructuralFeature feature) {
    KeyStroke key = KeyStroke.getInstance(SWT.CTRL, ' ');
    ContentProposalAdapter proposals =
        new ContentProposalAdapter(
            control,
            adapter,
            (contents, position) ->
                proposals(
                    completions.proposals(
                        element,
                        feature,
                        contents.substring(0, Math.min(position, contents.length())))),
            key,
            null);
    proposals.setProposalAcceptanceStyle(ContentProposalAdapter.PROPOSAL_REPLACE);
    ControlDecoration bulb = new ControlDecoration(control, SWT.LEFT | SWT.TOP);
    bulb.setImage(
        FieldDecorationRegistry.getDefault()
            .getFieldDecoration(FieldDecorationRegistry.DEC_CONTENT_PROPOSAL)
            .getImage());
    bulb.setDescriptionText("Ctrl+Space shows what can be written here.");
    bulb.setShowOnlyOnFocus(true);
  }

  private static IContentProposal[] proposals(List<String> texts) {
    return texts.stream()
        .distinct()
        .limit(MOST)
        .map(ContentProposal::new)
        .toArray(IContentProposal[]::new);
  }
}
