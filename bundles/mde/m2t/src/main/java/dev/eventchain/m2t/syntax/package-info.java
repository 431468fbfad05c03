/**
 * Reading templates: from the text of a file to a tree whose white space is settled. Knows neither
 * models nor expressions.
 */
package dev.eventchain.m2t.syntax;
