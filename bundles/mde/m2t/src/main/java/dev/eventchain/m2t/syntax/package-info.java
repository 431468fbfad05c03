/**
 * Parser of templates, from the text of a file to a tree with normalised white space. Independent
 * of models and expressions.
 */
package dev.eventchain.m2t.syntax;
