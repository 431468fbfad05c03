/**
 * Questions of editors about texts, as plain values: for language servers, plug-ins and other
 * programs. Independent of languages, protocols and user interfaces.
 */
package dev.eventchain.editing;
