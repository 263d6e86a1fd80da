<?php
// Validates items with TAO's QTI SDK (its XML schemas) and answers them in its item sessions.
//
//   php qti_sdk.php QTI_SDK FOLDER ATTEMPTS.json
//
// QTI_SDK is a checkout of oat-sa/qti-sdk, FOLDER an unpacked archive. ATTEMPTS is a list of {"item": file, "responses": [{identifier:
// [type, text], ...}, ...]}; printed is {"version": ..., "marks": [[{outcome: number, ...}, ...], ...]}.

error_reporting(E_ERROR);
[, $sdk, $folder, $attempts] = $argv;
spl_autoload_register(function ($class) use ($sdk) {
    $file = $sdk . '/src/' . str_replace('\\', '/', $class) . '.php';
    if (is_file($file)) {
        require $file;
    }
});

use qtism\common\datatypes\files\FileSystemFileManager;
use qtism\common\datatypes\QtiFloat;
use qtism\common\datatypes\QtiIdentifier;
use qtism\common\datatypes\QtiString;
use qtism\common\enums\BaseType;
use qtism\common\enums\Cardinality;
use qtism\data\storage\xml\XmlDocument;
use qtism\runtime\common\ResponseVariable;
use qtism\runtime\common\State;
use qtism\runtime\tests\AssessmentItemSession;
use qtism\runtime\tests\SessionManager;

foreach (['test.xml'] as $file) {
    (new XmlDocument('2.1'))->loadFromString(file_get_contents("$folder/$file"), true);
}
$marks = [];
foreach (json_decode(file_get_contents($attempts), true) as $each) {
    $document = new XmlDocument('2.1');
    $document->loadFromString(file_get_contents("$folder/{$each['item']}"), true);
    $given = [];
    foreach ($each['responses'] as $response) {
        $session = new AssessmentItemSession($document->getDocumentComponent(), new SessionManager(new FileSystemFileManager()));
        $session->beginItemSession();
        $session->beginAttempt();
        $state = new State();
        foreach ($response as $name => [$type, $text]) {
            $value = match (true) {
                $text === '' => null,
                $type === 'float' => is_numeric($text) ? new QtiFloat((float) $text) : null,
                $type === 'identifier' => new QtiIdentifier($text),
                default => new QtiString($text),
            };
            $state->setVariable(new ResponseVariable($name, Cardinality::SINGLE, BaseType::getConstantByName($type), $value));
        }
        $session->endAttempt($state);
        $outcomes = [];
        foreach ($session as $name => $variable) {
            if (str_starts_with($name, 'SCORE')) {
                $outcomes[$name] = $variable->getValue() ? $variable->getValue()->getValue() : null;
            }
        }
        $given[] = $outcomes;
    }
    $marks[] = $given;
}
echo json_encode(['marks' => $marks]);
