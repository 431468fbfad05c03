/** What editors can know about rule documents, half-typed ones included. */
package dev.eventchain.constraints.editing;
