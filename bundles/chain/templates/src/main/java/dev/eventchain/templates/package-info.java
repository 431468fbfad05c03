/** Templates that ship with the program. */
package dev.eventchain.templates;
