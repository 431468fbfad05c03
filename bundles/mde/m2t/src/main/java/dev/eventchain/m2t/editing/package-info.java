/** What editors can know about templates, half-typed ones included. */
package dev.eventchain.m2t.editing;
