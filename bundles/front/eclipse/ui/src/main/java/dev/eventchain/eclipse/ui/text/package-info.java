/**
 * The editors of constraints and templates: what their texts consist of, in which colours, what can
 * be at a place and what is where.
 */
package dev.eventchain.eclipse.ui.text;
