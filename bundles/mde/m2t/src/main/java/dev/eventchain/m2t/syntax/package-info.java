/** Reading templates: from the text of a file to a tree whose white space is settled. */
package dev.eventchain.m2t.syntax;
