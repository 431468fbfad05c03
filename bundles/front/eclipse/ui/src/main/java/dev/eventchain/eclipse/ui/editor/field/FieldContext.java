package dev.eventchain.eclipse.ui.editor.field;

import dev.eventchain.eclipse.ui.editor.model.Completions;
import dev.eventchain.eclipse.ui.editor.model.EditedModel;
import java.util.function.Consumer;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.ui.forms.widgets.FormToolkit;

/**
 * What fields need of their editor.
 *
 * @param reveal shows an element in the tree
 * @param checked called when what is in a field has become possible or impossible
 */
public record FieldContext(
    FormToolkit toolkit,
    EditedModel model,
    Completions completions,
    Consumer<EObject> reveal,
    Runnable checked) {}
