/** Fields that show and edit one property of an element. They know the edited chain and no page. */
package dev.eventchain.eclipse.ui.editor.field;
