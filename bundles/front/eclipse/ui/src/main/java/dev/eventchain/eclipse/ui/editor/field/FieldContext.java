package dev.eventchain.eclipse.ui.editor.field;

import dev.eventchain.eclipse.ui.editor.model.Completions;
import dev.eventchain.eclipse.ui.editor.model.EditedModel;
import java.util.function.Consumer;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.ui.forms.widgets.FormToolkit;

/**
 * The services that an editor provides to its fields.
 *
 * @param reveal shows an element in the tree
 * @param checked called when the content of a field has become valid or invalid
 */
public record FieldContext(
    FormToolkit toolkit,
    EditedModel model,
    Completions completions,
    Consumer<EObject> reveal,
    Runnable checked) {}
