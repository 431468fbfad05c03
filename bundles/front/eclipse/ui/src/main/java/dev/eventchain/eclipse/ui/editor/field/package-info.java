/**
 * Fields that show and edit one property of an element. They depend on the edited chain, but on no
 * page.
 */
package dev.eventchain.eclipse.ui.editor.field;
